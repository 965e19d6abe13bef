#include "engine/contact/DeepestPoint.hpp"

#include <algorithm>
#include <cmath>

#include "engine/contact/ClosestPoint.hpp"

namespace thinwall {
namespace {

/// The bracket of a root halves at least every second turn: enough for all bits of a number from 0 to 1.
constexpr int kTurns = 120;

struct Slope {
  double value = 0;
  double derivative = 0;  // 0 where it is not known
};

/// Root in [0, 1] of a function that never falls, from `slope`: 0 or 1 where it has one sign only. Newton's step, or
/// that of the enclosing chord, as long as it stays within the bracket and shrinks it fast, halving otherwise.
template <typename Function>
double root_of_rising(const Function& slope) {
  double low = 0, high = 1;
  const Slope at_low = slope(0);
  if (at_low.value >= 0) return 0;
  const Slope at_high = slope(1);
  if (at_high.value <= 0) return 1;
  double low_value = at_low.value, high_value = at_high.value;
  double guess = low_value / (low_value - high_value), width = 1;
  int side = 0;
  for (int turn = 0; turn < kTurns; ++turn) {
    const Slope here = slope(guess);
    if (here.value == 0) return guess;
    const bool below = here.value < 0;
    (below ? low : high) = guess;
    (below ? low_value : high_value) = here.value;
    // The end of the bracket that stays counts for half (Illinois), so that chords close in from both sides.
    if (side == (below ? -1 : 1)) (below ? high_value : low_value) *= 0.5;
    side = below ? -1 : 1;
    double next = here.derivative > 0 ? guess - here.value / here.derivative
                                      : low + (high - low) * low_value / (low_value - high_value);
    if (turn % 3 == 2) {
      if (high - low > 0.5 * width) next = 0.5 * (low + high);
      width = high - low;
    }
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - guess) < 1e-16 || next == low || next == high) return next;
    guess = next;
  }
  return guess;
}

/// Part of the way from one point to another at which the signed distance is least.
double deepest_part(const ToolSolid& solid, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d way = to - from;
  if (solid.is_ball()) {
    const double along = way.dot(solid.center - from);
    return along <= 0 ? 0 : std::min(1.0, along / way.squaredNorm());
  }
  return root_of_rising([&](double part) {
    const SignedDistance distance = signed_distance(solid, from + part * way);
    return Slope{.value = distance.normal.dot(way) + solid.crown * (part - 0.5),
                 .derivative = way.dot(distance.curvature * way) + solid.crown};
  });
}

Eigen::Vector3d position_of(const DeepestPoint& point, const std::array<Eigen::Vector3d, 3>& corners) {
  return point.weights[0] * corners[0] + point.weights[1] * corners[1] + point.weights[2] * corners[2];
}

/// The deepest point inside a triangle, known not to lie on its border. Chords run parallel to the edge that leaves out
/// the corner `top`; the part of the way to it is what the outer search is over.
DeepestPoint deepest_inside(const ToolSolid& solid, const std::array<Eigen::Vector3d, 3>& corners, int top) {
  const int left = (top + 1) % 3, right = (top + 2) % 3;
  const Eigen::Vector3d to_top_left = corners[top] - corners[left], to_top_right = corners[top] - corners[right];
  double along = 0;
  const double up = root_of_rising([&](double part) {
    const Eigen::Vector3d from = corners[left] + part * to_top_left, to = corners[right] + part * to_top_right;
    along = deepest_part(solid, from, to);
    const SignedDistance distance = signed_distance(solid, from + along * (to - from));
    // At the top the chord has no length: the way down is the steepest between the two edges.
    if (part == 1) return Slope{std::max(distance.normal.dot(to_top_left), distance.normal.dot(to_top_right)), 0};
    return Slope{.value = distance.normal.dot((1 - along) * to_top_left + along * to_top_right), .derivative = 0};
  });
  along = deepest_part(solid, corners[left] + up * to_top_left, corners[right] + up * to_top_right);
  DeepestPoint point{.weights = Eigen::Vector3d::Zero(), .corners = {0, 1, 2}, .corner_count = 3};
  point.weights[top] = up;
  point.weights[left] = (1 - up) * (1 - along);
  point.weights[right] = (1 - up) * along;
  return point;
}

}  // namespace

DeepestPoint deepest_on_edge(const ToolSolid& solid, const std::array<Eigen::Vector3d, 3>& corners, int from, int to) {
  const double part = deepest_part(solid, corners[from], corners[to]);
  DeepestPoint point;
  point.weights[from] = 1 - part;
  point.weights[to] = part;
  point.corners = {from, to, 0};
  point.corner_count = 2;
  if (part == 0 || part == 1) {
    point.corners = {part == 0 ? from : to, 0, 0};
    point.corner_count = 1;
  }
  return point;
}

DeepestPoint deepest_on_triangle(const ToolSolid& solid, const std::array<Eigen::Vector3d, 3>& corners) {
  if (solid.is_ball()) {
    const ClosestPoint closest = closest_point(corners, solid.center);
    return {.weights = closest.weights, .corners = closest.corners, .corner_count = closest.corner_count};
  }
  DeepestPoint best;
  SignedDistance at_best;
  int top = 0;
  for (int k = 0; k < 3; ++k) {
    const DeepestPoint candidate = deepest_on_edge(solid, corners, k, (k + 1) % 3);
    const SignedDistance distance = signed_distance(solid, position_of(candidate, corners));
    if (k > 0 && !(distance.value < at_best.value)) continue;
    best = candidate;
    at_best = distance;
    top = (k + 2) % 3;
  }
  // A corner that is deepest on both of its edges is deepest on the triangle between them.
  if (best.corner_count == 1) return best;
  const Eigen::Vector3d inwards = corners[top] - position_of(best, corners);
  if (at_best.normal.dot(inwards) >= -1e-12 * inwards.norm()) return best;
  const DeepestPoint inside = deepest_inside(solid, corners, top);
  return inside.weights.minCoeff() > 0 ? inside : best;
}

}  // namespace thinwall
