#pragma once

#include <array>
#include <optional>
#include <vector>

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/PictureLayout.hpp"

namespace thinwall {

/// A place of a picture in OpenCV's way of counting, in pixels: x to the right, y down, from the middle of the upper
/// left pixel.
using PicturePoint = std::array<double, 2>;

/// Where the ray of a picture's point meets the plane at distance one before the camera: x to the right, y down.
using RayPoint = std::array<double, 2>;

/// The part of a picture that a camera fills.
struct PicturePart {
  ImageSize picture = {};
  PictureBox own = {};
  std::optional<PictureBox> covered = {};  // by another camera's small picture
};

/// What of a picture of `size` belongs to the shot's own camera.
PicturePart own_part(const Shot& shot, ImageSize size);

/// Nothing of it.
PicturePart covered_part(ImageSize size);

/// Where points land in pictures of a camera, and what their pixels look at.
class Projection {
 public:
  Projection(const Camera& camera, const PicturePart& part);

  ImageSize size() const { return part_.picture; }
  double nearest() const { return camera_.nearest; }  // metres; what is nearer is not seen

  /// Metres in the camera's axes: x to the right, y down, z along the line of sight.
  Vector3 in_camera(Vector3 point) const;

  /// Where a point in the camera's axes lands, in or beside its part; nothing where it is not before the camera.
  std::optional<PicturePoint> land(Vector3 in_camera) const;

  /// The ray of a point of the picture; nothing outside the camera's part of it or an endoscope's field stop.
  std::optional<RayPoint> ray(PicturePoint point) const;

  /// (height x width) rays of the middles of the pixels.
  const std::vector<std::optional<RayPoint>>& rays() const { return rays_; }

 private:
  Camera camera_;
  PicturePart part_;
  double stop_ = 0;  // radius of the field stop at distance one; 0 for none
  std::vector<std::optional<RayPoint>> rays_;
};

}  // namespace thinwall
