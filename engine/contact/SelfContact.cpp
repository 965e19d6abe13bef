#include "engine/contact/SelfContact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/contact/ContinuousCollision.hpp"
#include "engine/contact/LipNeighbours.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// Largest range of the potentials as a part of the mean edge length, and margin of the list as one of the edges at a
/// vertex. Range and twice the margin stay below the height of a regular triangle, 0.87: a smooth wall lists nothing.
constexpr double kRange = 0.4;
constexpr double kMargin = 0.1;

/// Part of the stress-free distance of a pair at which it begins to feel each other.
constexpr double kRestRange = 0.5;

/// Stress-free distances below this part of the mean edge length count as touching.
constexpr double kTouching = 1e-6;

/// Part of the range below which two parts that a cut has left so are in each other: what kept them apart before, that
/// they shared a vertex or were neighbours, the cut has ended.
constexpr double kInEachOther = 0.02;

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

SelfContact::SelfContact(const SelfContactDefinition& definition)
    : triangles_(definition.triangles.begin(), definition.triangles.end()),
      rest_position_(definition.position),
      placement_(definition.placement),
      floors_(definition.floors),
      pressure_(definition.pressure) {
  const std::size_t vertices = rest_position_.size() / 3;
  held_.resize(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    held_[v] = definition.fixed[3 * v] && definition.fixed[3 * v + 1] && definition.fixed[3 * v + 2];
  }
  measure_parts(definition);
  tree_ = TriangleTree(triangles_, rest_position_, margins_);
  measure_heights(definition);
  across_ = neighbours_across_cuts(triangles_, rest_position_);
  gather_stars();
}

void SelfContact::measure_parts(const SelfContactDefinition& definition) {
  const int vertices = static_cast<int>(held_.size());
  vertex_area_.assign(vertices, 0);
  vertex_thickness_.assign(vertices, 0);
  parts_.resize(triangles_.size());
  std::vector<char> claimed(vertices, 0);
  double thickest = 0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const auto corner = [&](int k) { return rest_position_.segment<3>(3 * triangles_[t][k]); };
    const double third = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 6;
    thickest = std::max(thickest, definition.thickness[t]);
    for (const int vertex : triangles_[t]) {
      vertex_area_[vertex] += third;
      vertex_thickness_[vertex] += third * definition.thickness[t];
      if (!claimed[vertex]) parts_[t].vertices.push_back(vertex);
      claimed[vertex] = 1;
    }
  }
  for (int v = 0; v < vertices; ++v) {
    if (vertex_area_[v] > 0) vertex_thickness_[v] /= vertex_area_[v];
  }
  const MeshTopology topology = topology_of(vertices, triangles_);
  margins_.assign(vertices, 0);
  std::vector<int> ends(vertices, 0);
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const auto& [low, high] = topology.edges[e];
    const double length = (rest_position_.segment<3>(3 * high) - rest_position_.segment<3>(3 * low)).norm();
    edge_length_ += length;
    for (const int vertex : {low, high}) {
      margins_[vertex] += kMargin * length;
      ++ends[vertex];
    }
    parts_[triangles_at(topology, static_cast<int>(e)).front()].edges.push_back(topology.edges[e]);
  }
  edge_length_ /= std::max<double>(1, static_cast<double>(topology.edges.size()));
  largest_range_ = std::min(thickest, kRange * edge_length_);
  for (int v = 0; v < vertices; ++v) {
    if (ends[v] > 0) margins_[v] /= ends[v];
  }
}

void SelfContact::measure_heights(const SelfContactDefinition& definition) {
  for (const FloorPlane& floor : floors_) {
    std::vector<double>& heights = heights_.emplace_back(held_.size(), 0);
    for (const Eigen::Vector3i& triangle : triangles_) {
      for (const int v : triangle) {
        if (held_[v]) continue;
        const double height = floor.normal.dot(definition.position.segment<3>(3 * v)) - floor.height;
        if (height > kTouching * edge_length_) heights[v] = height;
      }
    }
  }
}

bool SelfContact::covers(const Eigen::VectorXd& position) const {
  if (listings_ == 0) return false;
  const Eigen::Vector3d drift = mean_of(position, held_.size()) - mean_of(listed_position_, held_.size());
  for (std::size_t v = 0; v < held_.size(); ++v) {
    const Eigen::Index k = 3 * static_cast<Eigen::Index>(v);
    const Eigen::Vector3d moved = position.segment<3>(k) - listed_position_.segment<3>(k) - drift;
    if (moved.squaredNorm() >= margins_[v] * margins_[v] && margins_[v] > 0) return false;
  }
  return true;
}

double SelfContact::margin_of(const Eigen::Vector4i& vertices) const {
  double largest = 0;
  for (const int vertex : vertices) largest = std::max(largest, margins_[vertex]);
  return 2 * largest;
}

template <typename Visit>
void SelfContact::visit_parts(int triangle, int other, const Visit& visit) const {
  const auto apart = [](const Eigen::Vector4i& v) {
    return v[0] != v[1] && v[0] != v[2] && v[0] != v[3] && v[1] != v[2] && v[1] != v[3];
  };
  const auto visit_if_free = [&](PairKind kind, const Eigen::Vector4i& vertices) {
    const bool held = held_[vertices[0]] && held_[vertices[1]] && held_[vertices[2]] && held_[vertices[3]];
    if (!held && apart(vertices)) visit(kind, vertices);
  };
  for (const auto& [one, two] : {std::array{triangle, other}, std::array{other, triangle}}) {
    const Eigen::Vector3i& corners = triangles_[two];
    for (const int vertex : parts_[one].vertices) {
      visit_if_free(PairKind::kPointTriangle, {vertex, corners[0], corners[1], corners[2]});
    }
  }
  for (const auto& first : parts_[triangle].edges) {
    for (const auto& second : parts_[other].edges) {
      visit_if_free(PairKind::kEdgeEdge, {first[0], first[1], second[0], second[1]});
    }
  }
}

void SelfContact::list_near(const Eigen::VectorXd& position) {
  near_.clear();
  tree_.fit(position);
  const auto corners = [&](int triangle) -> std::array<Eigen::Vector3d, 3> {
    const Eigen::Vector3i& v = triangles_[triangle];
    return {position.segment<3>(3 * v[0]), position.segment<3>(3 * v[1]), position.segment<3>(3 * v[2])};
  };
  tree_.visit_near(largest_range_, kRestRange, [&](int triangle, int other, double reach) {
    if (share_vertex(triangles_[triangle], triangles_[other])) return;
    if (clearly_apart(corners(triangle), corners(other), reach)) return;
    visit_parts(triangle, other,
                [&](PairKind kind, const Eigen::Vector4i& vertices) { list_if_near(kind, vertices, position); });
  });
  listed_position_ = position;
  ++listings_;
}

std::optional<NearPair> SelfContact::describe(PairKind kind, const Eigen::Vector4i& vertices) const {
  const PairCorners rest = corners_at(vertices, rest_position_);
  const double rest_distance = pair_distance(kind, rest).distance;
  if (is_left_alone(kind, vertices, rest_distance)) return std::nullopt;
  double thickness = 0, area = 0;
  for (const int vertex : vertices) thickness += 0.25 * vertex_thickness_[vertex];
  // Each place of the wall is counted by its points and by its edges (three to a point), and once from either side.
  if (kind == PairKind::kPointTriangle) {
    area = 0.25 * vertex_area_[vertices[0]];
  } else {
    for (const int vertex : vertices) area += 0.25 / 12 * vertex_area_[vertex];
  }
  return NearPair{.kind = kind,
                  .vertices = vertices,
                  .range = std::min({thickness, largest_range_, kRestRange * rest_distance}),
                  .area = area,
                  .parallel = kind == PairKind::kEdgeEdge ? parallel_bound(rest) : 0};
}

void SelfContact::list_if_near(PairKind kind, const Eigen::Vector4i& vertices, const Eigen::VectorXd& position) {
  const PairCorners corners = corners_at(vertices, position);
  const double margin = margin_of(vertices);
  if (least_distance(kind, corners) > largest_range_ + margin) return;
  const double distance = pair_distance(kind, corners).distance;
  if (distance > largest_range_ + margin) return;
  const std::optional<NearPair> pair = describe(kind, vertices);
  if (pair && distance <= pair->range + margin) near_.push_back(*pair);
}

bool SelfContact::were_neighbours(PairKind kind, const Eigen::Vector4i& vertices) const {
  const int first = kind == PairKind::kPointTriangle ? 1 : 2;
  for (int a = 0; a < first; ++a) {
    for (int b = first; b < 4; ++b) {
      const int one = vertices[a], other = vertices[b];
      if (std::ranges::binary_search(across_[one], other) || std::ranges::binary_search(across_[other], one)) {
        return true;
      }
    }
  }
  return false;
}

void SelfContact::gather_stars() {
  std::vector<std::vector<int>> around(held_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (const int vertex : triangles_[t]) around[vertex].push_back(static_cast<int>(t));
  }
  std::vector<std::vector<NearPair>> pairs(held_.size());
  for (std::size_t v = 0; v < around.size(); ++v) {
    for (std::size_t i = 0; i < around[v].size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const int one = around[v][j], other = around[v][i];
        // Triangles with an edge in common belong to the star of its lower vertex.
        int lowest = std::numeric_limits<int>::max();
        for (const int vertex : triangles_[one]) {
          if ((triangles_[other].array() == vertex).any()) lowest = std::min(lowest, vertex);
        }
        if (lowest != static_cast<int>(v)) continue;
        visit_parts(one, other, [&](PairKind kind, const Eigen::Vector4i& vertices) {
          if (const auto pair = describe(kind, vertices)) pairs[v].push_back(*pair);
        });
      }
    }
  }
  std::vector<double> margins = margins_;
  for (double& margin : margins) margin *= 2;
  stars_ = StarPairs(triangles_, std::move(pairs), margins, rest_position_);
}

bool SelfContact::is_left_alone(PairKind kind, const Eigen::Vector4i& vertices, double rest_distance) const {
  if (rest_distance < kTouching * edge_length_ || were_neighbours(kind, vertices)) return true;
  if (placement_.size() == 0) return false;
  const double distance = pair_distance(kind, corners_at(vertices, placement_)).distance;
  return distance < kInEachOther * std::min(largest_range_, kRestRange * rest_distance);
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

double SelfContact::safe_fraction(const Eigen::VectorXd& position, const Eigen::VectorXd& motion) {
  double fraction = safe_fraction_above_floors(position, motion);
  fraction = std::min(fraction, stars_.safe_fraction(position, motion));
  const auto fraction_of = [&](PairKind kind, const Eigen::Vector4i& vertices) {
    return thinwall::safe_fraction(kind, corners_at(vertices, position), corners_at(vertices, motion));
  };
  // What is not listed stays out of range as long as the list covers both ends of the motion: one that is made for
  // the middle covers twice its margin.
  const Eigen::Vector3d drift = mean_of(motion, held_.size());
  const auto is_short = [&](std::size_t v) {
    return (motion.segment<3>(3 * static_cast<Eigen::Index>(v)) - drift).norm() < 1.8 * margins_[v] || margins_[v] == 0;
  };
  bool all_short = true;
  for (std::size_t v = 0; all_short && v < held_.size(); ++v) all_short = is_short(v);
  if (all_short && !(covers(position) && covers(position + motion))) list_near(position + 0.5 * motion);
  if (covers(position) && covers(position + motion)) {
    for (const NearPair& pair : near_) fraction = std::min(fraction, fraction_of(pair.kind, pair.vertices));
    return fraction;
  }
  tree_.fit(position, motion);
  tree_.visit_meeting([&](int triangle, int other) {
    if (share_vertex(triangles_[triangle], triangles_[other])) return;
    visit_parts(triangle, other, [&](PairKind kind, const Eigen::Vector4i& vertices) {
      const double one = fraction_of(kind, vertices);
      if (one >= fraction) return;
      const double rest_distance = pair_distance(kind, corners_at(vertices, rest_position_)).distance;
      if (!is_left_alone(kind, vertices, rest_distance)) fraction = one;
    });
  });
  return fraction;
}

template <typename Visit>
void SelfContact::visit_near(const Visit& visit) const {
  stars_.visit_near(visit);
  for (const NearPair& pair : near_) visit(pair);
}

void SelfContact::evaluate(const Eigen::VectorXd& position, SelfContactTerms& terms, Eigen::VectorXd& gradient) {
  terms.energy = terms.largest_force = 0;
  terms.folds.clear();
  terms.floors.clear();
  stars_.refresh(position);
  if (!covers(position)) list_near(position);
  add_folds(position, terms, gradient);
  add_floors(position, terms, gradient);
}

void SelfContact::add_folds(const Eigen::VectorXd& position, SelfContactTerms& terms, Eigen::VectorXd& gradient) const {
  visit_near([&](const NearPair& near) {
    const PairCorners corners = corners_at(near.vertices, position);
    if (least_distance(near.kind, corners) >= near.range) return;
    const PairDistance closest = pair_distance(near.kind, corners);
    if (closest.distance >= near.range) return;
    const FoldContact contact{.vertices = near.vertices,
                              .pair = {.kind = near.kind,
                                       .corners = corners,
                                       .closest = closest,
                                       .potential = {.range = near.range, .pressure = pressure_, .area = near.area},
                                       .parallel = near.parallel}};
    const FoldTerms part = contact.pair.terms();
    terms.energy += part.energy;
    for (int k = 0; k < 4; ++k) gradient.segment<3>(3 * near.vertices[k]) += part.gradient.segment<3>(3 * k);
    terms.largest_force = std::max(terms.largest_force, part.gradient.cwiseAbs().maxCoeff());
    terms.folds.push_back(contact);
  });
}

void SelfContact::add_floors(const Eigen::VectorXd& position, SelfContactTerms& terms,
                             Eigen::VectorXd& gradient) const {
  for (std::size_t f = 0; f < floors_.size(); ++f) {
    for (std::size_t v = 0; v < held_.size(); ++v) {
      if (heights_[f][v] == 0) continue;
      const Eigen::Index at = 3 * static_cast<Eigen::Index>(v);
      const double height = floors_[f].normal.dot(position.segment<3>(at)) - floors_[f].height;
      const FoldPotential potential{
          .range = std::min({vertex_thickness_[v], largest_range_, kRestRange * heights_[f][v]}),
          .pressure = pressure_,
          .area = vertex_area_[v]};
      if (height >= potential.range) continue;
      FloorContact contact{.vertex = static_cast<int>(v), .normal = floors_[f].normal, .terms = potential.at(height)};
      terms.energy += contact.terms.energy;
      gradient.segment<3>(at) += contact.terms.slope * contact.normal;
      terms.largest_force = std::max(terms.largest_force, std::abs(contact.terms.slope));
      terms.floors.push_back(contact);
    }
  }
}

std::size_t SelfContact::listed() const {
  std::size_t count = 0;
  visit_near([&](const NearPair&) { ++count; });
  return count;
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
