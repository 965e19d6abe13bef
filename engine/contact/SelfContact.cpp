#include "engine/contact/SelfContact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "engine/contact/LipNeighbours.hpp"
#include "engine/mesh/MeshTopology.hpp"

namespace thinwall {
namespace {

/// Largest range of the potentials as a part of the mean edge length, and margin of the list as one of the edges at a
/// vertex. Range and twice the margin stay below the height of a regular triangle, 0.87: a smooth wall lists nothing.
constexpr double kRange = 0.4;
constexpr double kMargin = 0.1;

/// Stress-free distances below this part of the mean edge length count as touching.
constexpr double kTouching = 1e-6;

/// Part of the range below which two parts that a cut has left so are in each other: what kept them apart before, that
/// they shared a vertex or were neighbours, the cut has ended.
constexpr double kInEachOther = 0.02;

}  // namespace

SelfContact::SelfContact(const SelfContactDefinition& definition) : SelfContact(definition, nullptr) {}

SelfContact::SelfContact(const SelfContactDefinition& definition, const SelfContact& before)
    : SelfContact(definition, &before) {}

SelfContact::SelfContact(const SelfContactDefinition& definition, const SelfContact* before)
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
  tree_ = before == nullptr ? TriangleTree(triangles_, rest_position_, margins_)
                            : TriangleTree(triangles_, rest_position_, margins_, before->tree_);
  measure_heights(definition);
  across_ = neighbours_across_cuts(triangles_, rest_position_);
  left_alone_.assign(vertices, 0);
  is_new_ = before != nullptr ? has_changed_since(*before) : std::vector<char>(vertices, 1);
  gather_stars(before != nullptr ? &before->stars_ : nullptr);
  if (before != nullptr) carry_list(*before);
}

void SelfContact::measure_parts(const SelfContactDefinition& definition) {
  const int vertices = static_cast<int>(held_.size());
  vertex_area_.assign(vertices, 0);
  vertex_thickness_.assign(vertices, 0);
  vertex_shrink_.assign(vertices, 1);
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
      if (!definition.stretch.empty()) {
        vertex_shrink_[vertex] = std::min(vertex_shrink_[vertex], 1 / definition.stretch[t]);
      }
      if (!claimed[vertex]) parts_[t].add_vertex(vertex);
      claimed[vertex] = 1;
    }
  }
  for (int v = 0; v < vertices; ++v) {
    if (vertex_area_[v] > 0) vertex_thickness_[v] /= vertex_area_[v];
  }
  const MeshEdges mesh = edges_of(vertices, triangles_);
  margins_.assign(vertices, 0);
  std::vector<int> ends(vertices, 0);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto& [low, high] = mesh.edges[e];
    const double length = (rest_position_.segment<3>(3 * high) - rest_position_.segment<3>(3 * low)).norm();
    edge_length_ += length;
    for (const int vertex : {low, high}) {
      margins_[vertex] += kMargin * length;
      ++ends[vertex];
    }
    parts_[triangles_at(mesh, static_cast<int>(e)).front()].add_edge(mesh.edges[e]);
  }
  edge_length_ /= std::max<double>(1, static_cast<double>(mesh.edges.size()));
  if (definition.edge_length > 0) edge_length_ = definition.edge_length;
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

std::optional<NearPair> SelfContact::describe(PairKind kind, const Eigen::Vector4i& vertices) {
  const double rest_distance = rest_distance_of(kind, vertices);
  if (is_left_alone(kind, vertices, rest_distance)) {
    if (is_in_each_other(kind, vertices, rest_distance)) {
      // Several threads may mark the same vertex.
      for (const int vertex : vertices) std::atomic_ref(left_alone_[vertex]).store(1, std::memory_order_relaxed);
    }
    return std::nullopt;
  }
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
                  .parallel = parallel_bound(kind, corners_at(vertices, rest_position_))};
}

double SelfContact::rest_distance_of(PairKind kind, const Eigen::Vector4i& vertices) const {
  double shrink = 1;
  for (const int vertex : vertices) shrink = std::min(shrink, vertex_shrink_[vertex]);
  return shrink * pair_distance(kind, corners_at(vertices, rest_position_)).distance;
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

void SelfContact::gather_stars(const StarPairs* before) {
  // A star is known where none of its vertices is new.
  std::vector<char> anew = is_new_;
  for (const Eigen::Vector3i& triangle : triangles_) {
    const bool is_known = !is_new_[triangle[0]] && !is_new_[triangle[1]] && !is_new_[triangle[2]];
    for (const int vertex : triangle) anew[vertex] = anew[vertex] || !is_known;
  }
  std::vector<std::vector<int>> around(held_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (const int vertex : triangles_[t]) {
      if (anew[vertex]) around[vertex].push_back(static_cast<int>(t));
    }
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
  stars_ = StarPairs(triangles_, std::move(pairs), margins, placement_.size() > 0 ? placement_ : rest_position_);
  if (before != nullptr) stars_.keep(*before, anew);
}

bool SelfContact::is_left_alone(PairKind kind, const Eigen::Vector4i& vertices, double rest_distance) const {
  return rest_distance < kTouching * edge_length_ || were_neighbours(kind, vertices) ||
         is_in_each_other(kind, vertices, rest_distance);
}

bool SelfContact::is_in_each_other(PairKind kind, const Eigen::Vector4i& vertices, double rest_distance) const {
  if (placement_.size() == 0) return false;
  const double distance = pair_distance(kind, corners_at(vertices, placement_)).distance;
  return distance < kInEachOther * std::min(largest_range_, kRestRange * rest_distance);
}

void SelfContact::look(const Eigen::VectorXd& position) {
  stars_.refresh(position);
  if (!covers(position)) list_near(position, position);
}

void SelfContact::evaluate(const Eigen::VectorXd& position, SelfContactTerms& terms, Eigen::VectorXd& gradient) const {
  terms.energy = terms.largest_force = 0;
  terms.folds.clear();
  terms.floors.clear();
  add_folds(position, terms, gradient);
  add_floors(position, terms, gradient);
}

void SelfContact::add_folds(const Eigen::VectorXd& position, SelfContactTerms& terms, Eigen::VectorXd& gradient) const {
  visit_near([&](const NearPair& near) {
    const auto pair = fold_of(near, position, pressure_);
    if (!pair) return;
    const FoldTerms part = pair->terms();
    terms.energy += part.energy;
    for (int k = 0; k < 4; ++k) gradient.segment<3>(3 * near.vertices[k]) += part.gradient.segment<3>(3 * k);
    terms.largest_force = std::max(terms.largest_force, part.gradient.cwiseAbs().maxCoeff());
    terms.folds.push_back({.vertices = near.vertices, .pair = *pair});
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

}  // namespace thinwall
