#include "studio/recorder/EmptyPictureNotes.hpp"

#include <algorithm>
#include <limits>

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/PictureLayout.hpp"
#include "renderer/camera/SceneExtent.hpp"

namespace thinwall {
namespace {

constexpr double kSpeck = 0.01;  // of the picture's smaller side

/// What the vertices of all walls span in a picture, in pixels.
struct Span {
  double left = std::numeric_limits<double>::infinity();
  double top = left;
  double right = -left;
  double bottom = -left;
  bool is_partly_behind = false;  // vertices behind the camera have no place in the picture

  bool has_pixels() const { return left <= right; }
  bool is_beside(ImageSize size) const {
    return !has_pixels() || right < 0 || bottom < 0 || left > size.width || top > size.height;
  }
  double extent() const { return std::max(right - left, bottom - top); }
};

Span span_of(const Snapshot& snapshot, const Camera& camera, ImageSize size) {
  Span span;
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    for (const auto& position : surface.positions) {
      const auto pixel = camera.pixel(vector3(position), size);
      if (!pixel) {
        span.is_partly_behind = true;
        continue;
      }
      span.left = std::min(span.left, (*pixel)[0]);
      span.right = std::max(span.right, (*pixel)[0]);
      span.top = std::min(span.top, (*pixel)[1]);
      span.bottom = std::max(span.bottom, (*pixel)[1]);
    }
  }
  return span;
}

}  // namespace

void EmptyPictureNotes::see(const Snapshot& snapshot, const Shot& shot, ImageSize size) {
  if (was_seen_) return;
  has_pictures_ = true;
  const ImageSize main = main_box(shot, size).size;
  const Span span = span_of(snapshot, resolve_camera(shot.camera, scene_extent(snapshot), main, snapshot.time), main);
  if (shot.beside || shot.inset || (span.has_pixels() && span.is_partly_behind)) {
    was_seen_ = true;  // as far as is known: other cameras, and triangles that reach past the camera
  } else if (!span.is_beside(main)) {
    const bool is_speck = span.extent() < kSpeck * std::min(main.width, main.height);
    is_speck_ = is_speck_ || is_speck;
    was_seen_ = !is_speck;
  }
}

std::vector<std::string> EmptyPictureNotes::notes() const {
  if (!has_pictures_ || was_seen_) return {};
  const std::string what = is_speck_
                               ? "in all pictures the bodies are specks; see whether the unit of `position` is meant"
                               : "no picture shows anything of a body";
  return {"camera: " + what + "; without `position` and `target` the bodies fill the picture"};
}

}  // namespace thinwall
