#pragma once

#include <optional>

#include "renderer/camera/SceneExtent.hpp"
#include "renderer/camera/View.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// A pinhole camera with all decided.
struct Camera {
  Vector3 position;        // metres
  Vector3 right;           // of length one, like the next two
  Vector3 up;              // of the picture
  Vector3 forward;         // line of sight
  double tangent_x = 1;    // of half the horizontal field of view
  double tangent_y = 1;    // of half the vertical field of view
  double nearest = 0.001;  // metres along the line of sight
  double farthest = 10;    // metres along the line of sight
  CameraKind kind = CameraKind::kPinhole;
  double field_stop = 0;  // tangent of the angle off the line of sight that the lens lets through; 0: all
  Lens lens = Lens();
  double aperture = 0;  // metres, 0: all is in focus
  double focus = 1;     // metres along the line of sight

  /// World to clip coordinates, without the lens's distortion.
  Matrix4 matrix() const;

  /// Where a point lands through the lens, in pixels from the upper left corner of the picture, x to the right and y
  /// down; nothing for points behind the camera.
  std::optional<std::array<double, 2>> pixel(Vector3 point, ImageSize size) const;

  /// Whether a place of a picture, in such pixels, lies within it and within the field stop.
  bool shows(const std::array<double, 2>& pixel, ImageSize size) const;
};

/// Completes `definition` for a picture of `size` at `time` (seconds). What is absent follows from the rest points:
/// a three-quarter view from above that shows them whole, with room for a title above, a caption below, a plot at the
/// lower right; from farther off where walls have grown out of that. Throws PictureFailure when position and target
/// coincide or the field of view is not inside (0, pi).
Camera resolve_camera(const CameraDefinition& definition, const SceneExtent& extent, ImageSize size, double time);

/// The pinhole at the camera's place whose picture holds all that its lens brings into the camera's, with the field
/// stop as it is seen there. Throws PictureFailure when the lens folds the picture over.
Camera behind_the_lens(const Camera& camera);

/// The same camera before anything moves it.
Camera resting_camera(const CameraDefinition& definition, const SceneExtent& extent, ImageSize size);

}  // namespace thinwall
