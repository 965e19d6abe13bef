#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/SurfacePlace.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// A stress-free surface.
struct RestSurface {
  const std::vector<Float3>& positions;    // (vertices x 3), metres
  const std::vector<Triangle>& triangles;  // (triangles x 3)
};

/// Finds the places of one stress-free surface on another, which cuts have made of it or before it: both cover the same
/// places in space but for little. A triangle with the same number and the same corners in space is the same; of the
/// rest, the triangle that is nearest to the place holds it. Both surfaces must outlive this.
class TriangleMatch {
 public:
  TriangleMatch(const RestSurface& from, const RestSurface& to);

  /// Nothing where the other surface has no wall there.
  std::optional<SurfacePlace> find(const SurfacePlace& place) const;

 private:
  RestSurface from_;
  RestSurface to_;
  std::vector<char> is_same_;           // (triangles of `from`)
  std::vector<std::uint32_t> changed_;  // triangles of `to` that are not the same
};

/// The nearest point of a triangle as weights of its corners, and its distance (Ericson 2005, section 5.1.5).
std::pair<std::array<double, 3>, double> nearest_weights(Vector3 point, const std::array<Vector3, 3>& corners);

}  // namespace thinwall
