#include "renderer/ground_truth/Projection.hpp"

#include <cmath>

namespace thinwall {

namespace {

bool is_inside(PicturePoint point, const PictureBox& box) {
  const double x = point[0] + 0.5 - box.left, y = point[1] + 0.5 - box.top;
  return x >= 0 && y >= 0 && x <= box.size.width && y <= box.size.height;
}

}  // namespace

PicturePart own_part(const Shot& shot, ImageSize size) {
  PicturePart part{.picture = size, .own = main_box(shot, size), .covered = {}};
  if (shot.inset) part.covered = inset_box(shot, size);
  return part;
}

PicturePart covered_part(ImageSize size) {
  const PictureBox all{.left = 0, .top = 0, .size = size};
  return {.picture = size, .own = all, .covered = all};
}

Projection::Projection(const Camera& camera, const PicturePart& part)
    : camera_(camera), part_(part), stop_(camera.field_stop) {
  for (int row = 0; row < part.picture.height; ++row) {
    for (int column = 0; column < part.picture.width; ++column) {
      rays_.push_back(ray({static_cast<double>(column), static_cast<double>(row)}));
    }
  }
}

Vector3 Projection::in_camera(Vector3 point) const {
  const Vector3 offset = point - camera_.position;
  return {dot(offset, camera_.right), -dot(offset, camera_.up), dot(offset, camera_.forward)};
}

std::optional<PicturePoint> Projection::land(Vector3 in_camera) const {
  if (!(in_camera.z > 0)) return std::nullopt;
  const RayPoint ideal = {in_camera.x / in_camera.z, in_camera.y / in_camera.z};
  if (!camera_.lens.is_unfolded(ideal)) return std::nullopt;
  const RayPoint seen = camera_.lens.distorted(ideal);
  const auto& [left, top, size] = part_.own;
  return PicturePoint{left + 0.5 * size.width * (1 + seen[0] / camera_.tangent_x) - 0.5,
                      top + 0.5 * size.height * (1 + seen[1] / camera_.tangent_y) - 0.5};
}

std::optional<RayPoint> Projection::ray(PicturePoint point) const {
  const auto& [left, top, size] = part_.own;
  if (!is_inside(point, part_.own) || (part_.covered && is_inside(point, *part_.covered))) return std::nullopt;
  const RayPoint seen = {(2 * (point[0] + 0.5 - left) / size.width - 1) * camera_.tangent_x,
                         (2 * (point[1] + 0.5 - top) / size.height - 1) * camera_.tangent_y};
  if (stop_ > 0 && std::hypot(seen[0], seen[1]) > stop_) return std::nullopt;
  return camera_.lens.undistorted(seen);
}

}  // namespace thinwall
