#include "engine/cutting/WantedPath.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <stdexcept>
#include <string>

namespace thinwall {
namespace {

/// Weights below this are zero: the point lies on the edge or the vertex.
constexpr double kNoWeight = 1e-9;

PatchPlace vertex_place(const CutPatch& patch, int vertex) {
  // A vertex inside a facet is a place in it like any other; the cut need not keep it.
  if (patch.freedom[vertex] == VertexFreedom::kFree) {
    return {.kind = PlaceKind::kFace,
            .facet = patch.facet[patch.vertex_triangle[vertex]],
            .position = patch.positions[vertex]};
  }
  return {.kind = PlaceKind::kVertex, .vertex = vertex, .position = patch.positions[vertex]};
}

PatchPlace place_of(const CutPatch& patch, const SurfacePoint& point) {
  const Eigen::Vector3i& corners = patch.triangles[point.triangle];
  Eigen::Vector3d weights = point.weights;
  for (double& weight : weights) weight = weight < kNoWeight ? 0 : weight;
  weights /= weights.sum();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) position += weights[k] * patch.positions[corners[k]];
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    if (weights[next] == 0 && weights[last] == 0) return vertex_place(patch, corners[k]);
    if (weights[last] == 0 && weights[k] != 0 && weights[next] != 0 && patch.is_crease(point.triangle, k)) {
      return {.kind = PlaceKind::kSide,
              .from = corners[k],
              .to = corners[next],
              .along = weights[next],
              .position = position};
    }
  }
  return {.kind = PlaceKind::kFace, .facet = patch.facet[point.triangle], .position = position};
}

/// The first facet that both places touch, or -1.
int common_facet(const CutPatch& patch, const PatchPlace& a, const PatchPlace& b) {
  const std::vector<int> of_a = facets_at(patch, a), of_b = facets_at(patch, b);
  for (const int facet : of_a) {
    if (std::find(of_b.begin(), of_b.end(), facet) != of_b.end()) return facet;
  }
  return -1;
}

bool is_same(const PatchPlace& a, const PatchPlace& b) {
  return a.kind == b.kind && a.vertex == b.vertex && a.position == b.position;
}

}  // namespace

std::vector<int> facets_at(const CutPatch& patch, const PatchPlace& place) {
  std::vector<int> facets;
  if (place.kind == PlaceKind::kFace) facets.push_back(place.facet);
  if (place.kind == PlaceKind::kSide) {
    for (const auto& [from, to] : {std::pair(place.from, place.to), std::pair(place.to, place.from)}) {
      const int triangle = patch.side_between(from, to).triangle;
      if (triangle >= 0) facets.push_back(patch.facet[triangle]);
    }
  }
  if (place.kind == PlaceKind::kVertex) {
    for (const PatchCorner& corner : patch.fan_of(place.vertex).corners) {
      const int facet = patch.facet[corner.triangle];
      if (std::find(facets.begin(), facets.end(), facet) == facets.end()) facets.push_back(facet);
    }
  }
  return facets;
}

std::vector<PathStop> read_path(const CutPatch& patch, std::optional<int> from, std::span<const SurfacePoint> points) {
  std::vector<PatchPlace> places;
  if (from) {
    places.push_back({.kind = PlaceKind::kVertex, .vertex = *from, .position = patch.positions[*from]});
  }
  for (const SurfacePoint& point : points) {
    PatchPlace place = place_of(patch, point);
    if (places.empty() || !is_same(places.back(), place)) places.push_back(std::move(place));
  }
  std::vector<PathStop> stops;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool last = i + 1 == places.size();
    const int facet = last ? -1 : common_facet(patch, places[i], places[i + 1]);
    if (!last && facet < 0) {
      throw std::invalid_argument("a cut path leaves the surface between its points " + std::to_string(i) + " and " +
                                  std::to_string(i + 1) + ": they lie in no common triangle or flat piece");
    }
    if (i == 0 || last || places[i].kind != PlaceKind::kFace) {
      stops.push_back({.place = places[i], .facet = facet, .between = {}});
    } else {
      stops.back().between.push_back(places[i].position);
    }
  }
  return stops;
}

std::vector<Eigen::Vector3d> corners_of(std::span<const PathStop> stops) {
  std::vector<Eigen::Vector3d> corners;
  for (const PathStop& stop : stops) {
    corners.push_back(stop.place.position);
    corners.insert(corners.end(), stop.between.begin(), stop.between.end());
  }
  return corners;
}

double distance_to(std::span<const Eigen::Vector3d> polyline, const Eigen::Vector3d& point) {
  double nearest = (point - polyline.front()).norm();
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    const Eigen::Vector3d along = polyline[i + 1] - polyline[i];
    const double square = along.squaredNorm();
    if (square == 0) continue;
    const double t = std::clamp((point - polyline[i]).dot(along) / square, 0.0, 1.0);
    nearest = std::min(nearest, (point - polyline[i] - t * along).norm());
  }
  return nearest;
}

}  // namespace thinwall
