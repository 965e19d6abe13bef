#include "renderer/ground_truth/Projection.hpp"

#include <cmath>

#include "renderer/picture/FrameUniforms.hpp"

namespace thinwall {

Projection::Projection(const Camera& camera, ImageSize size)
    : camera_(camera), size_(size), stop_(field_stop(camera)) {
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
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
  return PicturePoint{0.5 * size_.width * (1 + in_camera.x / (in_camera.z * camera_.tangent_x)) - 0.5,
                      0.5 * size_.height * (1 + in_camera.y / (in_camera.z * camera_.tangent_y)) - 0.5};
}

std::optional<RayPoint> Projection::ray(PicturePoint point) const {
  const auto [x, y] = point;
  if (x < -0.5 || y < -0.5 || x > size_.width - 0.5 || y > size_.height - 0.5) return std::nullopt;
  const RayPoint seen = {(2 * (x + 0.5) / size_.width - 1) * camera_.tangent_x,
                         (2 * (y + 0.5) / size_.height - 1) * camera_.tangent_y};
  if (stop_ > 0 && std::hypot(seen[0], seen[1]) > stop_) return std::nullopt;
  return seen;
}

}  // namespace thinwall
