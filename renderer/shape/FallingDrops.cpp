#include "renderer/shape/FallingDrops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/snapshot/Float3.hpp"
#include "renderer/wound/FluidLevel.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 0.0013;  // metres: about 10 microlitres, what water lets go from a surface
constexpr double kPeriod = 0.11;    // seconds between two drops of a run
constexpr double kEarth = 9.81;     // metres / second^2
constexpr double kFarthest = 0.08;  // metres, below which nothing of a scene is
constexpr int kRings = 8, kSpokes = 14;

/// Longer along its way the faster it is, at the same volume.
void append_drop(Vector3 middle, Vector3 down, double stretch, Film& film) {
  const Vector3 right = perpendicular(down), front = cross(down, right);
  const auto offset = static_cast<std::uint32_t>(film.vertices.size());
  const double thin = 1 / std::sqrt(stretch);
  for (int ring = 0; ring <= kRings; ++ring) {
    const double tilt = std::numbers::pi * ring / kRings;
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double turn = 2 * std::numbers::pi * spoke / kSpokes;
      const Vector3 aside = std::cos(turn) * right + std::sin(turn) * front;
      const Vector3 out = std::cos(tilt) * stretch * down + std::sin(tilt) * thin * aside;
      const Vector3 normal = normalized(std::cos(tilt) / stretch * down + std::sin(tilt) / thin * aside);
      film.vertices.push_back({.position = float3(middle + kRadius * out),
                               .normal = float3(normal),
                               .rest = float3(kRadius * out),
                               .inward = static_cast<float>(kRadius),
                               .width = static_cast<float>(0.1 * kRadius),
                               .height = static_cast<float>(1.5 * kRadius)});
    }
  }
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t spoke = 0; spoke < kSpokes; ++spoke) {
      const std::uint32_t a = offset + ring * kSpokes + spoke, b = offset + ring * kSpokes + (spoke + 1) % kSpokes;
      for (const std::uint32_t corner : {a, a + kSpokes, b, b, a + kSpokes, b + kSpokes})
        film.corners.push_back(corner);
    }
  }
}

}  // namespace

Film falling_drops(const SnapshotSurface& surface, const WoundLayout& wounds, Vector3 gravity, double leaked,
                   double time) {
  Film film;
  const double strength = length(gravity);
  const Vector3 down = normalized(gravity);
  const double longest = std::sqrt(2 * kFarthest / strength);
  constexpr double kVolume = 4.0 / 3 * std::numbers::pi * kRadius * kRadius * kRadius;
  for (const FluidRun& run : wounds.fluid_runs) {
    const double way = static_cast<double>(run.path.size() - 1) * kRunStep;
    // What is on the way is not there to fall.
    const auto [half_width, height] = runoff_section(run, wounds, leaked);
    const double shape = 2 * half_width * height;
    const double left = share_of_run(wounds, leaked) - way * shape;
    const double arrival = run.born + way / kRunoffSpeed + kPeriod * run.chance;
    const Vector3 end = point_at(run.path.back(), surface.positions);
    for (int n = std::max(0, static_cast<int>((time - longest - arrival) / kPeriod)); n * kVolume < left; ++n) {
      const double falling = time - arrival - n * kPeriod;
      if (falling < 0) break;
      const double fallen = 0.5 * strength * falling * falling;
      if (fallen < kFarthest) append_drop(end + (kRadius + fallen) * down, down, 1 + 0.3 * falling / longest, film);
    }
  }
  return film;
}

Vector3 gravity_of_drops(const Snapshot& snapshot) {
  const Vector3 gravity = vector3(snapshot.gravity);
  return length(gravity) > 0 ? gravity : kEarth * downward(snapshot);
}

}  // namespace thinwall
