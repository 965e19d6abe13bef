#include "renderer/ground_truth/GroundTruth.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "renderer/ground_truth/Openings.hpp"
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

WoundPart wound_part(const SceneGeometry& geometry, const ScenePart& part, std::uint32_t triangle) {
  // A whole wall has no opening that it would be seen through.
  const bool is_open = !geometry.is_cut[part.owner].empty();
  if (part.kind == PartKind::kLining) return is_open ? WoundPart::kInside : WoundPart::kNothing;
  if (part.kind != PartKind::kRim) return WoundPart::kNothing;
  const bool is_cut = geometry.is_cut[part.owner][(triangle - part.first_triangle) / 2] != 0;
  return is_cut ? WoundPart::kCutFace : WoundPart::kNothing;
}

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
  const std::vector<char> through = rays_through_openings(frame.snapshot(), geometry, frame.moment().projection);
  for (std::size_t pixel = 0; pixel < places.size(); ++pixel) {
    const ScenePlace& place = places[pixel];
    if (place.triangle == kNoIndex) {
      if (through[pixel]) truth.wound[pixel] = WoundPart::kThrough;
      continue;
    }
    const SceneTriangle& triangle = geometry.triangles[place.triangle];
    const ScenePart& part = geometry.parts[triangle.part];
    truth.depth[pixel] = static_cast<float>(frame.seen().depth[pixel]);
    truth.normals[pixel] = float3(normal_at(frame, place));
    const std::size_t instance = part.owner + (part.kind == PartKind::kTool ? surfaces.size() : 0);
    truth.instances[pixel] = static_cast<std::uint16_t>(1 + instance);
    truth.parts[pixel] = static_cast<std::uint16_t>(kPartKinds * instance + 1 + static_cast<std::size_t>(part.kind));
    truth.wound[pixel] = wound_part(geometry, part, place.triangle);
    if (part.kind == PartKind::kTool) continue;
    const SurfaceTruth& surface = surfaces[part.owner];
    if (has_stress && triangle.wall != kNoIndex) truth.von_mises[pixel] = surface.von_mises[triangle.wall];
    if (has_pressure && part.kind == PartKind::kOutside) {
      truth.contact_pressure[pixel] = pressure_at(surface, geometry, place);
    }
  }
  return truth;
}

}  // namespace thinwall
