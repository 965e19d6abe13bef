#include "renderer/ground_truth/GroundTruth.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "renderer/ground_truth/Openings.hpp"
#include "renderer/shape/WithinBody.hpp"
#include "renderer/snapshot/SurfaceFields.hpp"

namespace thinwall {
namespace {

std::array<float, 3> float3(Vector3 a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

/// In the camera's axes, towards the viewer, whichever side of the triangle is seen. What is between the vertices'
/// normals may turn away from the viewer near an outline: there it is across the line of sight, as on the outline.
Vector3 normal_at(const SeenFrame& frame, const ScenePlace& place) {
  const SceneGeometry& geometry = frame.geometry();
  const auto& corners = geometry.triangles[place.triangle].corners;
  Vector3 sum, point;
  for (std::size_t k = 0; k < 3; ++k) {
    sum = sum + place.weights[k] * geometry.normals[corners[k]];
    point = point + place.weights[k] * geometry.points[corners[k]];
  }
  const Vector3 face = cross(geometry.points[corners[1]] - geometry.points[corners[0]],
                             geometry.points[corners[2]] - geometry.points[corners[0]]);
  const Camera& camera = frame.camera();
  const bool is_front = dot(face, camera.position - geometry.points[corners[0]]) >= 0;
  Vector3 normal = normalized(is_front ? sum : -sum);
  const Vector3 sight = normalized(point - camera.position);
  if (const double away = dot(normal, sight); away > 0) normal = normalized(normal - away * sight);
  return {dot(normal, camera.right), -dot(normal, camera.up), dot(normal, camera.forward)};
}

/// What all pixels of one surface need to look up.
struct SurfaceTruth {
  std::vector<float> von_mises;         // (triangles of the mesh), pascal; empty where there is none
  std::vector<float> contact_pressure;  // (vertices as drawn), pascal; empty where there is none
};

float pressure_at(const SurfaceTruth& surface, const SceneGeometry& geometry, const ScenePlace& place) {
  double pressure = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = geometry.vertices[geometry.triangles[place.triangle].corners[k]];
    pressure += place.weights[k] * surface.contact_pressure[vertex];
  }
  return static_cast<float>(pressure);
}

/// (surfaces), whether all that is seen of the inner side is seen through what cuts have opened: they alone have, and
/// the viewer is not within. Slack lips may let it out beside the opening itself.
std::vector<char> are_open_by_cuts_alone(const SeenFrame& frame) {
  std::vector<char> result;
  for (const SnapshotSurface& surface : frame.snapshot().surfaces) {
    const std::vector<char>& is_cut = frame.geometry().is_cut[result.size()];
    const bool by_cuts = !is_cut.empty() && std::ranges::all_of(is_cut, [](char cut) { return cut != 0; });
    result.push_back(by_cuts && !lies_within(surface, frame.camera().position) ? 1 : 0);
  }
  return result;
}

/// What the pictures show of wounds.
class WoundParts {
 public:
  explicit WoundParts(const SeenFrame& frame)
      : frame_(frame),
        openings_(rays_through_openings(frame.snapshot(), frame.geometry(), frame.moment().projection)),
        open_by_cuts_alone_(are_open_by_cuts_alone(frame)) {}

  WoundPart at(std::size_t pixel) const {
    const ScenePlace& place = frame_.seen().places[pixel];
    if (place.triangle == kNoIndex) return openings_.within[pixel] ? WoundPart::kThrough : WoundPart::kNothing;
    const ScenePart& part = frame_.geometry().parts[frame_.geometry().triangles[place.triangle].part];
    if (part.kind == PartKind::kRim) {
      const bool is_cut = frame_.geometry().is_cut[part.owner][(place.triangle - part.first_triangle) / 2] != 0;
      return is_cut ? WoundPart::kCutFace : WoundPart::kNothing;
    }
    const bool is_inside = part.kind == PartKind::kLining || part.kind == PartKind::kCap;
    return is_inside && is_through(part, pixel) ? WoundPart::kInside : WoundPart::kNothing;
  }

 private:
  /// Whether what a pixel shows of a body's inner side is seen through an opening of it. Caps have their outer side,
  /// too.
  bool is_through(const ScenePart& part, std::size_t pixel) const {
    if (part.kind == PartKind::kLining && open_by_cuts_alone_[part.owner]) return true;
    const std::vector<double>& depth = openings_.depth[part.owner];
    return !depth.empty() && depth[pixel] < frame_.seen().depth[pixel];
  }

  const SeenFrame& frame_;
  Openings openings_;
  std::vector<char> open_by_cuts_alone_;  // (surfaces)
};

}  // namespace

SeenFrame::SeenFrame(Snapshot snapshot, const Shot& shot, ImageSize size, DrawnEdges edges, bool is_covered)
    : snapshot_(std::move(snapshot)),
      part_(is_covered ? covered_part(size) : own_part(shot, size)),
      camera_(resolve_camera(shot.camera, scene_extent(snapshot_), part_.own.size, snapshot_.time)),
      geometry_(scene_geometry(snapshot_, scene_extent(snapshot_), edges, camera_.position)),
      projection_(camera_, part_),
      seen_(see(geometry_, projection_)) {}

GroundTruth ground_truth(const SeenFrame& frame) {
  const SceneGeometry& geometry = frame.geometry();
  const std::vector<ScenePlace>& places = frame.seen().places;
  std::vector<SurfaceTruth> surfaces;
  bool has_stress = true, has_pressure = true;
  for (const SnapshotSurface& surface : frame.snapshot().surfaces) {
    const SnapshotField* pressure = find_field(surface, kContactPressureField, FieldLocation::kVertex);
    const SmoothSurface& smooth = geometry.drawn[surfaces.size()].smooth;
    surfaces.push_back(
        {.von_mises = von_mises_stress(surface),
         .contact_pressure = pressure == nullptr ? std::vector<float>() : refined(pressure->values, smooth)});
    has_stress = has_stress && !surfaces.back().von_mises.empty();
    has_pressure = has_pressure && pressure != nullptr;
  }
  GroundTruth truth{.size = frame.seen().size,
                    .depth = std::vector<float>(places.size()),
                    .normals = std::vector<std::array<float, 3>>(places.size()),
                    .instances = std::vector<std::uint16_t>(places.size()),
                    .parts = std::vector<std::uint16_t>(places.size()),
                    .von_mises = std::vector<float>(has_stress ? places.size() : 0),
                    .contact_pressure = std::vector<float>(has_pressure ? places.size() : 0),
                    .wound = std::vector<WoundPart>(places.size())};
  const WoundParts wounds(frame);
  for (std::size_t pixel = 0; pixel < places.size(); ++pixel) {
    const ScenePlace& place = places[pixel];
    truth.wound[pixel] = wounds.at(pixel);
    if (place.triangle == kNoIndex) continue;
    const SceneTriangle& triangle = geometry.triangles[place.triangle];
    const ScenePart& part = geometry.parts[triangle.part];
    truth.depth[pixel] = static_cast<float>(frame.seen().depth[pixel]);
    truth.normals[pixel] = float3(normal_at(frame, place));
    const std::size_t instance = part.owner + (part.kind == PartKind::kTool ? surfaces.size() : 0);
    truth.instances[pixel] = static_cast<std::uint16_t>(1 + instance);
    truth.parts[pixel] = static_cast<std::uint16_t>(kPartKinds * instance + 1 + static_cast<std::size_t>(part.kind));
    if (part.kind == PartKind::kTool) continue;
    const SurfaceTruth& surface = surfaces[part.owner];
    if (has_stress && triangle.wall != kNoIndex) truth.von_mises[pixel] = surface.von_mises[triangle.wall];
    // A wall is touched as a whole, whichever of its sides is seen.
    if (has_pressure && part.kind != PartKind::kCap) {
      truth.contact_pressure[pixel] = pressure_at(surface, geometry, place);
    }
  }
  return truth;
}

}  // namespace thinwall
