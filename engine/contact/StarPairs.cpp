#include "engine/contact/StarPairs.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/contact/ContinuousCollision.hpp"
#include "engine/contact/LeastOf.hpp"

namespace thinwall {
namespace {

Eigen::Vector3d offset_at(const Eigen::VectorXd& position, int center, int vertex) {
  return position.segment<3>(3 * vertex) - position.segment<3>(3 * center);
}

}  // namespace

StarPairs::StarPairs(std::span<const Eigen::Vector3i> triangles, std::vector<std::vector<NearPair>> pairs,
                     std::span<const double> margins, const Eigen::VectorXd& position) {
  std::vector<std::vector<int>> rings(pairs.size());
  for (const Eigen::Vector3i& triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      if (pairs[triangle[k]].empty()) continue;
      rings[triangle[k]].push_back(triangle[(k + 1) % 3]);
      rings[triangle[k]].push_back(triangle[(k + 2) % 3]);
    }
  }
  for (std::size_t v = 0; v < pairs.size(); ++v) {
    if (pairs[v].empty()) continue;
    std::sort(rings[v].begin(), rings[v].end());
    rings[v].erase(std::unique(rings[v].begin(), rings[v].end()), rings[v].end());
    append({.center = static_cast<int>(v),
            .margin = margins[v],
            .pairs = std::make_shared<const std::vector<NearPair>>(std::move(pairs[v]))},
           rings[v]);
    measure(position, stars_.back());
  }
}

void StarPairs::append(Star star, std::span<const int> ring) {
  star.begin = static_cast<int>(ring_.size());
  ring_.insert(ring_.end(), ring.begin(), ring.end());
  star.end = static_cast<int>(ring_.size());
  offsets_.resize(ring_.size());
  stars_.push_back(std::move(star));
}

void StarPairs::append(const StarPairs& other, const Star& star) {
  append(star, std::span(other.ring_).subspan(star.begin, star.end - star.begin));
  std::copy(other.offsets_.begin() + star.begin, other.offsets_.begin() + star.end,
            offsets_.begin() + stars_.back().begin);
}

void StarPairs::keep(const StarPairs& other, std::span<const char> without) {
  const StarPairs own = std::exchange(*this, {});
  stars_.reserve(own.stars_.size() + other.stars_.size());
  ring_.reserve(own.ring_.size() + other.ring_.size());
  offsets_.reserve(ring_.capacity());
  auto next = own.stars_.begin();
  for (const Star& star : other.stars_) {
    if (without[star.center]) continue;
    for (; next != own.stars_.end() && next->center < star.center; ++next) append(own, *next);
    append(other, star);
  }
  for (; next != own.stars_.end(); ++next) append(own, *next);
}

void StarPairs::measure(const Eigen::VectorXd& position, Star& star) {
  for (int k = star.begin; k < star.end; ++k) offsets_[k] = offset_at(position, star.center, ring_[k]);
  star.near.clear();
  star.slack = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < star.pairs->size(); ++k) {
    const NearPair& pair = (*star.pairs)[k];
    const double room = pair_distance(pair.kind, corners_at(pair.vertices, position)).distance - pair.range;
    if (room < star.margin) {
      star.near.push_back(static_cast<int>(k));
    } else {
      star.slack = std::min(star.slack, room);
    }
  }
}

void StarPairs::refresh(const Eigen::VectorXd& position) {
  for (Star& star : stars_) {
    // Two vertices of a star move relative to each other by twice what they move relative to the centre at most.
    const double allowed = 0.25 * star.slack * star.slack;
    for (int k = star.begin; k < star.end; ++k) {
      if ((offset_at(position, star.center, ring_[k]) - offsets_[k]).squaredNorm() < allowed) continue;
      measure(position, star);
      break;
    }
  }
}

double StarPairs::safe_fraction(const Eigen::VectorXd& position, const Eigen::VectorXd& motion) const {
  const auto fraction_of = [&](const NearPair& pair) {
    return thinwall::safe_fraction(pair.kind, corners_at(pair.vertices, position), corners_at(pair.vertices, motion));
  };
  return least_of(stars_.size(), 1, [&](std::size_t s) {
    const Star& star = stars_[s];
    const double allowed = 0.25 * star.slack * star.slack;
    bool covered = true;
    for (int k = star.begin; covered && k < star.end; ++k) {
      const Eigen::Vector3d before = offset_at(position, star.center, ring_[k]) - offsets_[k];
      const Eigen::Vector3d after = before + offset_at(motion, star.center, ring_[k]);
      covered = before.squaredNorm() < allowed && after.squaredNorm() < allowed;
    }
    double fraction = 1;
    if (covered) {
      for (const int pair : star.near) fraction = std::min(fraction, fraction_of((*star.pairs)[pair]));
    } else {
      for (const NearPair& pair : *star.pairs) fraction = std::min(fraction, fraction_of(pair));
    }
    return fraction;
  });
}

}  // namespace thinwall
