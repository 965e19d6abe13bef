#include "renderer/annotation/AnnotationScene.hpp"

#include <algorithm>

#include "renderer/annotation/MaterialPoint.hpp"

namespace thinwall {

bool AnnotationScene::shows(PixelPoint at) const {
  if (inset && at[0] > inset->x && at[0] < inset->right() && at[1] > inset->y && at[1] < inset->bottom()) return false;
  return camera.shows(at, size);
}

std::optional<MaterialPlace> material_place(const Snapshot& snapshot, const std::string& body, const Double3& at) {
  const auto surface = std::ranges::find(snapshot.surfaces, body, &SnapshotSurface::body);
  if (surface == snapshot.surfaces.end()) return std::nullopt;
  const std::optional<MaterialPoint> point = nearest_material_point(*surface->topology, at);
  if (!point) return std::nullopt;
  return MaterialPlace{.now = place_of(*point, *surface), .at_rest = rest_place_of(*point, *surface->topology)};
}

std::vector<PixelPoint> tool_obstacles(const AnnotationScene& scene, const std::vector<ToolShape>& tools) {
  std::vector<PixelPoint> obstacles;
  const auto add = [&](Vector3 place) {
    const std::optional<PixelPoint> at = scene.pixel(place);
    if (at && scene.shows(*at)) obstacles.push_back(*at);
  };
  constexpr int kAlongRods = 64;
  for (const ToolShape& shape : tools) {
    for (const ToolVertex& vertex : shape.vertices) add(vector3(vertex.position));
    for (const ToolRod& rod : shape.rods) {
      const Vector3 start = vector3(rod.start), span = vector3(rod.end) - start;
      for (int i = 0; i <= kAlongRods; ++i) add(start + (static_cast<double>(i) / kAlongRods) * span);
    }
  }
  return obstacles;
}

Camera resting_camera_at(const AnnotationScene& scene, double time) {
  CameraDefinition camera = scene.definition;
  camera.followed_point.reset();
  SceneExtent extent = scene.extent;
  extent.grown_points.clear();
  return resolve_camera(camera, extent, scene.size, time);
}

bool is_left_of_middle(const AnnotationScene& scene, Vector3 at_rest, double first_shown) {
  const Camera first = resting_camera_at(scene, first_shown);
  const auto place = first.pixel(at_rest, scene.size), middle = first.pixel(scene.extent.subject().center, scene.size);
  // Of an organ that is for the most part beside the picture its middle is there too: what is seen of it would all have
  // its labels on one side, across it.
  const double width = scene.size.width;
  return (place ? (*place)[0] : 0) < std::clamp(middle ? (*middle)[0] : 0.5 * width, 0.25 * width, 0.75 * width);
}

Box label_bounds(const AnnotationScene& scene) {
  const double margin = scene.grid.pixels(plate_style::kMargin);
  const double top = margin + scene.grid.pixels(52);
  const double bottom = scene.size.height - height_of_panels_and_captions(scene.grid) - scene.grid.pixels(12);
  return {margin, top, std::max(1.0, scene.size.width - 2 * margin), std::max(1.0, bottom - top)};
}

std::vector<Box> taken_in(const AnnotationScene& scene) {
  std::vector<Box> taken = scene.taken;
  if (scene.inset) taken.insert(taken.begin(), *scene.inset);
  return taken;
}

void draw_plate(const Canvas& canvas, const AnnotationScene& scene, const Text& text, const Box& box) {
  const double radius = scene.grid.pixels(7);
  canvas.fill_rounded(box, radius, plate_style::kFill.with_opacity(0.82));
  text.draw(canvas, box.x + 0.5 * (box.width - text.width()), box.y + 0.5 * (box.height - text.height()));
}

}  // namespace thinwall
