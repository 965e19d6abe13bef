#include "engine/contact/ContinuousCollision.hpp"

#include <algorithm>

namespace thinwall {
namespace {

/// Part of the allowed advance that is taken, so that round-off cannot overrun it.
constexpr double kAdvance = 0.9;

/// Advances after which the fraction reached so far is taken: parts that slide past each other closely ask for many.
constexpr int kMostAdvances = 2000;

/// The motions less their mean, which changes no distance.
PairCorners without_mean(const PairCorners& motions) {
  const Eigen::Vector3d mean = (motions[0] + motions[1] + motions[2] + motions[3]) / 4;
  return {motions[0] - mean, motions[1] - mean, motions[2] - mean, motions[3] - mean};
}

double travel_of(PairKind kind, const PairCorners& motions) {
  std::array<double, 4> length;
  for (int k = 0; k < 4; ++k) length[k] = motions[k].norm();
  if (kind == PairKind::kPointTriangle) return length[0] + std::max({length[1], length[2], length[3]});
  return std::max(length[0], length[1]) + std::max(length[2], length[3]);
}

}  // namespace

double relative_travel(PairKind kind, const PairCorners& motions) {
  return travel_of(kind, without_mean(motions));
}

double safe_fraction(PairKind kind, const PairCorners& corners, const PairCorners& motions) {
  const PairCorners relative = without_mean(motions);
  const double travel = travel_of(kind, relative);
  // Most pairs are far apart: that is told without their distance.
  if (travel <= kAdvance * (1 - kKeptDistance) * least_distance(kind, corners)) return 1;
  double distance = pair_distance(kind, corners).distance;
  const double kept = kKeptDistance * distance;
  if (travel <= kAdvance * (distance - kept)) return 1;
  double fraction = 0;
  for (int advance = 0; advance < kMostAdvances; ++advance) {
    const double next = std::min(1.0, fraction + kAdvance * (distance - kept) / travel);
    PairCorners moved;
    for (int k = 0; k < 4; ++k) moved[k] = corners[k] + next * relative[k];
    distance = pair_distance(kind, moved).distance;
    // Not above: a degenerate part whose distance is not a number stops here as well.
    if (!(distance > kept)) return fraction;
    fraction = next;
    // The advances shrink geometrically towards a meeting; what is left then is not worth the queries.
    if (fraction == 1 || distance <= 1.01 * kept) return fraction;
  }
  return fraction;
}

}  // namespace thinwall
