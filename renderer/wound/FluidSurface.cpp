#include "renderer/wound/FluidSurface.hpp"

#include <array>
#include <cmath>

#include "renderer/snapshot/Float3.hpp"
#include "renderer/snapshot/SurfaceFields.hpp"

namespace thinwall {
namespace {

/// Part of the wall's thickness that fluid stands below the lips: of a body that is full, and of one that is not.
constexpr double kBelowLipsOfFull = 0.12;
constexpr double kBelowLips = 0.45;

/// Air that is less than this part of a cavity is rounding.
constexpr double kLeastAir = 1e-6;

std::vector<Triangle> closed_cavity(const SnapshotTopology& topology, std::span<const WallHole> holes) {
  std::vector<Triangle> closed = topology.triangles;
  closed.insert(closed.end(), topology.cap_triangles.begin(), topology.cap_triangles.end());
  for (const WallHole& hole : holes) closed.insert(closed.end(), hole.lid.begin(), hole.lid.end());
  return closed;
}

using LidCorner = std::array<Vector3, 2>;  // place and normal

/// The part of a triangle below the level, as a fan.
void append_below(const std::array<LidCorner, 3>& corners, Vector3 up, double level, std::vector<FluidVertex>& lid) {
  std::vector<LidCorner> below;
  for (std::size_t k = 0; k < 3; ++k) {
    const LidCorner &a = corners[k], &b = corners[(k + 1) % 3];
    const double a_above = dot(a[0], up) - level, b_above = dot(b[0], up) - level;
    if (a_above <= 0) below.push_back(a);
    if ((a_above < 0 && b_above > 0) || (a_above > 0 && b_above < 0)) {
      const double part = a_above / (a_above - b_above);
      below.push_back({a[0] + part * (b[0] - a[0]), normalized(a[1] + part * (b[1] - a[1]))});
    }
  }
  for (std::size_t k = 2; k < below.size(); ++k) {
    for (const LidCorner& corner : {below[0], below[k - 1], below[k]}) {
      lid.push_back({.position = float3(corner[0]), .normal = float3(corner[1])});
    }
  }
}

}  // namespace

FluidSurface fluid_surface(const Snapshot& snapshot, const SnapshotSurface& surface, std::span<const WallHole> holes,
                           std::span<const Vector3> normals, std::span<const double> thickness) {
  FluidSurface fluid;
  const double volume = find_scalar(snapshot, surface.body, kVolumeScalar).value_or(0);
  const double held = find_scalar(snapshot, surface.body, kFluidVolumeScalar).value_or(0);
  if (holes.empty() || !(held > 0)) return fluid;
  const Vector3 up = -downward(snapshot);
  const double air = volume - held > kLeastAir * volume ? volume - held : 0;
  double level = kBrimful;
  if (air > 0) {
    const std::vector<Triangle> closed = closed_cavity(*surface.topology, holes);
    level = fluid_level(surface.positions, closed, up, air);
    const std::vector<Vector3> contour = level_contour(surface.positions, closed, up, level);
    for (std::size_t k = 0; k + 1 < contour.size(); k += 2) {
      for (const Vector3 corner : {contour[0], contour[k], contour[k + 1]}) {
        fluid.level.push_back({.position = float3(corner), .normal = float3(up)});
      }
    }
  }
  const double below_lips = air > 0 ? kBelowLips : kBelowLipsOfFull;
  for (const WallHole& hole : holes) {
    const auto [mouth, outward] = mouth_of(hole, surface.positions);
    for (const Triangle& triangle : mouth) {
      std::array<LidCorner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = triangle[k];
        const Vector3 place = vector3(surface.positions[v]) - below_lips * thickness[v] * normals[v];
        corners[k] = {place, normalized(2.0 * outward + normals[v], outward)};
      }
      append_below(corners, up, level, fluid.lid);
    }
  }
  return fluid;
}

}  // namespace thinwall
