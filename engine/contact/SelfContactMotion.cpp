#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "engine/contact/ContinuousCollision.hpp"
#include "engine/contact/LeastOf.hpp"
#include "engine/contact/SelfContact.hpp"

namespace thinwall {
namespace {

/// Part of twice its margin that a vertex may move for a list that is made for the middle of the way to cover both
/// ends.
constexpr double kShortWay = 0.9;

/// Part of the vertices that may move farther for their pairs alone to be looked for along the way.
constexpr double kFewFar = 0.25;

/// Part of a distance that is more than what a safe fraction must keep of it.
constexpr double kSurelyKept = 1.05 * kKeptDistance;

bool share_vertex(const Eigen::Vector3i& one, const Eigen::Vector3i& other) {
  for (const int vertex : one) {
    if (vertex == other[0] || vertex == other[1] || vertex == other[2]) return true;
  }
  return false;
}

/// Whether a gap along the line between the centroids alone keeps two triangles farther apart than `reach`: cheap, and
/// true of most that lie beside each other.
bool clearly_apart(const std::array<Eigen::Vector3d, 3>& one, const std::array<Eigen::Vector3d, 3>& other,
                   double reach) {
  const Eigen::Vector3d axis = other[0] + other[1] + other[2] - one[0] - one[1] - one[2];
  const double gap = std::min({axis.dot(other[0]), axis.dot(other[1]), axis.dot(other[2])}) -
                     std::max({axis.dot(one[0]), axis.dot(one[1]), axis.dot(one[2])});
  return gap > 0 && gap * gap > reach * reach * axis.squaredNorm();
}

Eigen::Vector3d mean_of(const Eigen::VectorXd& vectors, std::size_t count) {
  const auto size = static_cast<Eigen::Index>(count);
  return vectors.head(3 * size).reshaped(3, size).rowwise().mean();
}

}  // namespace

Eigen::Vector3d SelfContact::drift_to(const Eigen::VectorXd& position) const {
  return mean_of(position, held_.size()) - mean_of(listed_position_, held_.size());
}

bool SelfContact::is_beyond(std::size_t vertex, const Eigen::VectorXd& position, const Eigen::Vector3d& drift) const {
  const Eigen::Index k = 3 * static_cast<Eigen::Index>(vertex);
  const Eigen::Vector3d moved = position.segment<3>(k) - listed_position_.segment<3>(k) - drift;
  return margins_[vertex] > 0 && moved.squaredNorm() >= margins_[vertex] * margins_[vertex];
}

bool SelfContact::covers(const Eigen::VectorXd& position) const {
  if (listings_ == 0) return false;
  const Eigen::Vector3d drift = drift_to(position);
  for (std::size_t v = 0; v < held_.size(); ++v) {
    if (is_new_[v] || is_beyond(v, position, drift)) return false;
  }
  return true;
}

void SelfContact::note_moved(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  moved_.assign(held_.size(), 1);
  if (listings_ == 0) {
    listed_position_ = 0.5 * (from + to);
    return;
  }
  const Eigen::Vector3d drift_from = drift_to(from), drift_on = drift_to(to);
  for (std::size_t v = 0; v < held_.size(); ++v) {
    moved_[v] = is_new_[v] || is_beyond(v, from, drift_from) || is_beyond(v, to, drift_on);
    if (!moved_[v]) continue;
    const Eigen::Index k = 3 * static_cast<Eigen::Index>(v);
    listed_position_.segment<3>(k) = 0.5 * (from.segment<3>(k) - drift_from + to.segment<3>(k) - drift_on);
  }
}

double SelfContact::margin_of(const Eigen::Vector4i& vertices) const {
  double largest = 0;
  for (const int vertex : vertices) largest = std::max(largest, margins_[vertex]);
  return 2 * largest;
}

double SelfContact::least_corner_distance(PairKind kind, const Eigen::Vector4i& vertices) const {
  const int first = kind == PairKind::kPointTriangle ? 1 : 2;
  double least = std::numeric_limits<double>::infinity();
  for (int a = 0; a < first; ++a) {
    for (int b = first; b < 4; ++b) {
      const auto between = rest_position_.segment<3>(3 * vertices[a]) - rest_position_.segment<3>(3 * vertices[b]);
      least = std::min(least, between.squaredNorm());
    }
  }
  return std::sqrt(least);
}

template <typename Add>
void SelfContact::visit_if_near(PairKind kind, const Eigen::Vector4i& vertices, const Add& add) {
  const PairCorners corners = corners_at(vertices, listed_position_);
  const double margin = margin_of(vertices);
  const double least = least_distance(kind, corners);
  if (least > largest_range_ + margin) return;
  const double reach = std::min(largest_range_, kRestRange * least_corner_distance(kind, vertices)) + margin;
  if (least > reach) return;
  const double distance = pair_distance(kind, corners).distance;
  if (distance > reach) return;
  const std::optional<NearPair> pair = describe(kind, vertices);
  if (pair && distance <= pair->range + margin) add(*pair);
}

void SelfContact::list_near(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  note_moved(from, to);
  tree_.fit(listed_position_);
  tree_.mark(moved_);
  const auto has_moved = [&](int triangle) {
    return std::ranges::any_of(triangles_[triangle], [&](int vertex) { return moved_[vertex] != 0; });
  };
  const auto corners = [&](int triangle) -> std::array<Eigen::Vector3d, 3> {
    const Eigen::Vector3i& v = triangles_[triangle];
    return {listed_position_.segment<3>(3 * v[0]), listed_position_.segment<3>(3 * v[1]),
            listed_position_.segment<3>(3 * v[2])};
  };
  std::erase_if(near_, [&](const ListedPair& pair) { return has_moved(pair.triangle) || has_moved(pair.other); });
  const auto kept = static_cast<std::ptrdiff_t>(near_.size());
  const auto begin = [&](std::size_t tasks) {
    found_.resize(std::max(found_.size(), tasks));
    for (std::vector<ListedPair>& found : found_) found.clear();
  };
  tree_.visit_near(largest_range_, kRestRange, begin, [&](std::size_t task, int triangle, int other, double reach) {
    if (share_vertex(triangles_[triangle], triangles_[other])) return;
    if (clearly_apart(corners(triangle), corners(other), reach)) return;
    const int low = std::min(triangle, other), high = std::max(triangle, other);
    visit_parts(low, high, [&](PairKind kind, const Eigen::Vector4i& vertices) {
      visit_if_near(kind, vertices, [&](const NearPair& pair) { found_[task].push_back({low, high, pair}); });
    });
  });
  for (const std::vector<ListedPair>& found : found_) near_.insert(near_.end(), found.begin(), found.end());
  const auto earlier = [](const ListedPair& one, const ListedPair& two) {
    return std::tie(one.triangle, one.other) < std::tie(two.triangle, two.other);
  };
  std::stable_sort(near_.begin() + kept, near_.end(), earlier);
  std::inplace_merge(near_.begin(), near_.begin() + kept, near_.end(), earlier);
  is_new_.assign(held_.size(), 0);
  ++listings_;
}

double SelfContact::safe_fraction_above_floors(const Eigen::VectorXd& position, const Eigen::VectorXd& motion) const {
  double fraction = 1;
  for (std::size_t f = 0; f < floors_.size(); ++f) {
    for (std::size_t v = 0; v < held_.size(); ++v) {
      if (heights_[f][v] == 0) continue;
      const Eigen::Index at = 3 * static_cast<Eigen::Index>(v);
      const double height = floors_[f].normal.dot(position.segment<3>(at)) - floors_[f].height;
      const double fall = -floors_[f].normal.dot(motion.segment<3>(at));
      if (fall * fraction > (1 - kKeptDistance) * height) fraction = (1 - kKeptDistance) * height / fall;
    }
  }
  return fraction;
}

std::size_t SelfContact::mark_far(const Eigen::VectorXd& motion) {
  const Eigen::Vector3d drift = mean_of(motion, held_.size());
  far_.assign(held_.size(), 0);
  std::size_t count = 0;
  for (std::size_t v = 0; v < held_.size(); ++v) {
    const Eigen::Vector3d way = motion.segment<3>(3 * static_cast<Eigen::Index>(v)) - drift;
    if (margins_[v] == 0 || way.norm() < 2 * kShortWay * margins_[v]) continue;
    far_[v] = 1;
    ++count;
  }
  return count;
}

double SelfContact::safe_fraction(const Eigen::VectorXd& position, const Eigen::VectorXd& motion) {
  double fraction = safe_fraction_above_floors(position, motion);
  fraction = std::min(fraction, stars_.safe_fraction(position, motion));
  const auto fraction_of = [&](PairKind kind, const Eigen::Vector4i& vertices) {
    return thinwall::safe_fraction(kind, corners_at(vertices, position), corners_at(vertices, motion));
  };
  // What is not listed stays out of range as long as the list covers both ends of the motion: one that is made for
  // the middle covers twice its margin. Where few vertices move farther than that, it covers the others.
  const std::size_t far = mark_far(motion);
  const Eigen::VectorXd end = position + motion;
  bool is_covered = covers(position) && covers(end);
  const bool is_listed = is_covered || static_cast<double>(far) <= kFewFar * static_cast<double>(held_.size());
  if (!is_covered && is_listed) {
    list_near(position, end);
    is_covered = far == 0;
  }
  if (is_listed) {
    fraction = least_of(near_.size(), fraction,
                        [&](std::size_t k) { return fraction_of(near_[k].pair.kind, near_[k].pair.vertices); });
  } else {
    far_.assign(held_.size(), 1);
  }
  if (is_covered) return fraction;
  tree_.mark(far_);
  tree_.fit(position, motion);
  std::vector<double> fractions;  // (tasks)
  const auto begin = [&](std::size_t tasks) { fractions.assign(tasks, fraction); };
  tree_.visit_meeting(kSurelyKept, begin, [&](std::size_t task, int triangle, int other) {
    if (share_vertex(triangles_[triangle], triangles_[other])) return;
    visit_parts(triangle, other, [&](PairKind kind, const Eigen::Vector4i& vertices) {
      const double one = fraction_of(kind, vertices);
      if (one >= fractions[task]) return;
      if (!is_left_alone(kind, vertices, rest_distance_of(kind, vertices))) fractions[task] = one;
    });
  });
  for (const double one : fractions) fraction = std::min(fraction, one);
  return fraction;
}

std::size_t SelfContact::listed_anew() const {
  return static_cast<std::size_t>(std::ranges::count(moved_, 1));
}

std::size_t SelfContact::listed() const {
  std::size_t count = 0;
  visit_near([&](const NearPair&) { ++count; });
  return count;
}

std::vector<NearPair> SelfContact::near_pairs_of(std::span<const char> marked) const {
  std::vector<NearPair> pairs;
  visit_near([&](const NearPair& pair) {
    const Eigen::Vector4i& v = pair.vertices;
    if (marked[v[0]] || marked[v[1]] || marked[v[2]] || marked[v[3]]) pairs.push_back(pair);
  });
  return pairs;
}

std::vector<std::array<int, 2>> SelfContact::near_couplings() const {
  std::vector<std::array<int, 2>> couplings;
  visit_near([&](const NearPair& pair) {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < a; ++b) {
        const auto [low, high] = std::minmax(pair.vertices[a], pair.vertices[b]);
        couplings.push_back({low, high});
      }
    }
  });
  std::sort(couplings.begin(), couplings.end());
  couplings.erase(std::unique(couplings.begin(), couplings.end()), couplings.end());
  return couplings;
}

}  // namespace thinwall
