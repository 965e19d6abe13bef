#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "renderer/shape/ToolShape.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// A point that goes with the material of a wall.
struct MaterialPoint {
  std::size_t triangle = 0;            // of the topology's wall
  std::array<double, 3> weights = {};  // barycentric, of its corners
};

/// The point of the stress-free wall that is nearest to `place` (metres); of equally near ones that of the first
/// triangle. It depends on the topology alone: over a cut, which changes the triangles but not the stress-free surface,
/// the same material is found again. Nothing when there are no triangles.
std::optional<MaterialPoint> nearest_material_point(const SnapshotTopology& topology, const Double3& place);

/// Where the point is now, metres.
Vector3 place_of(const MaterialPoint& point, const SnapshotSurface& surface);

/// Where it is on the stress-free wall, metres.
Vector3 rest_place_of(const MaterialPoint& point, const SnapshotTopology& topology);

/// Where the line through `at` along `direction` (unit) first meets the wall as it is now, coming from outside of all
/// of it; nothing where it passes the wall by. Metres.
std::optional<Vector3> first_met(const SnapshotSurface& surface, Vector3 at, Vector3 direction);

/// Whether a wall, a cap or one of `tools` stands between `eye` and `place`, a point of a surface (metres).
bool is_hidden(Vector3 place, Vector3 eye, const Snapshot& snapshot, std::span<const ToolShape> tools = {});

}  // namespace thinwall
