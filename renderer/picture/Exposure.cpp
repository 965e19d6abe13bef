#include "renderer/picture/Exposure.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

constexpr double kMostStops = 2;
// Mean radiance of a wall that the lamps, as they are tuned, show well.
constexpr double kWellLit = 0.32;

/// Luminance of a colour (Rec. 709).
double luminance_of(const Double3& color) {
  return 0.2126 * linear_from_srgb(color[0]) + 0.7152 * linear_from_srgb(color[1]) +
         0.0722 * linear_from_srgb(color[2]);
}

/// What counts of a wall's colour: a liver is dark also in a well exposed picture, so only a third of the steps that
/// lie between it and usual tissue are made up for.
double metered_luminance(const LookDefinition& look, const std::string& body) {
  const double usual = luminance_of(TissueLook{}.color);
  const auto found = look.bodies.find(body);
  return found == look.bodies.end() ? usual : usual * std::cbrt(luminance_of(found->second.color) / usual);
}

/// What a white matte wall would send back of the light that shines on it, as shaders/lamp.glsl has it.
double light_at(Vector3 place, Vector3 normal, const ViewDefinition& view, const FrameUniforms& frame,
                bool has_endoscope_lamp) {
  const Vector3 lamp{frame.key_direction[0], frame.key_direction[1], frame.key_direction[2]};
  const double strength = static_cast<double>(frame.key_direction[3]);
  if (has_endoscope_lamp) {
    const Vector3 toward = lamp - place;
    const double squared = dot(toward, toward);
    return squared > 0 ? strength / squared * std::max(0.0, dot(normal, normalized(toward))) : 0;
  }
  const Vector3 fill{frame.fill_direction[0], frame.fill_direction[1], frame.fill_direction[2]};
  return 1.8 * strength * std::max(0.0, dot(normal, lamp)) +
         0.34 * view.lights.fill * std::max(0.0, dot(normal, fill)) + 0.3 * view.lights.environment;
}

struct Meter {
  double light = 0;
  double weight = 0;
};

void meter(const SnapshotSurface& surface, const ViewDefinition& view, const Camera& camera, const FrameUniforms& frame,
           bool has_endoscope_lamp, Meter& sum) {
  const double luminance = metered_luminance(view.look, surface.body);
  for (const auto& [a, b, c] : surface.topology->triangles) {
    const Vector3 first = vector3(surface.positions[a]);
    const Vector3 across = cross(vector3(surface.positions[b]) - first, vector3(surface.positions[c]) - first);
    const Vector3 middle = (1.0 / 3) * (first + vector3(surface.positions[b]) + vector3(surface.positions[c]));
    const Vector3 offset = middle - camera.position;
    const double depth = dot(offset, camera.forward);
    if (depth < camera.nearest) continue;
    const double x = dot(offset, camera.right) / depth, y = dot(offset, camera.up) / depth;
    const bool is_stopped = camera.field_stop > 0 && std::hypot(x, y) > camera.field_stop;
    if (std::abs(x) > camera.tangent_x || std::abs(y) > camera.tangent_y || is_stopped) continue;
    // The part of the picture: twice the area, seen aslant, over the square of the depth.
    const double seen = -dot(across, offset) / (depth * depth * depth);
    if (seen <= 0) continue;
    sum.weight += seen;
    sum.light += seen * luminance * light_at(middle, normalized(across), view, frame, has_endoscope_lamp);
  }
}

}  // namespace

double metered_exposure(const Snapshot& snapshot, const ViewDefinition& view, const Camera& camera,
                        const FrameUniforms& frame, bool has_endoscope_lamp) {
  Meter sum;
  for (const SnapshotSurface& surface : snapshot.surfaces) meter(surface, view, camera, frame, has_endoscope_lamp, sum);
  if (!(sum.light > 0)) return sum.weight > 0 ? kMostStops : 0;
  return std::clamp(std::log2(kWellLit * sum.weight / sum.light), -kMostStops, kMostStops);
}

}  // namespace thinwall
