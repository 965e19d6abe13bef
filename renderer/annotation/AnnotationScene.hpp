#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/annotation/LabelLayout.hpp"
#include "renderer/camera/Camera.hpp"
#include "renderer/overlay/Plate.hpp"
#include "renderer/overlay/Text.hpp"
#include "renderer/shape/ToolShape.hpp"

namespace thinwall {

/// The look of texts beside organs and tools. Lengths in units of 1/720 of the picture's height.
namespace annotation_style {
inline constexpr double kTextSize = 17;
inline constexpr double kPadX = 11, kPadY = 6;
inline constexpr double kWidestText = 230;
}  // namespace annotation_style

/// What all annotations of a picture need.
struct AnnotationScene {
  const Snapshot& snapshot;
  const CameraDefinition& definition;
  SceneExtent extent;
  Camera camera;
  OverlayGrid grid;
  ImageSize size;            // of the part of the picture
  std::optional<Box> inset;  // of another picture, in this part
  std::vector<Box> taken;    // by a legend and captions, in this part
  std::vector<ToolShape> tools = {};

  std::optional<PixelPoint> pixel(Vector3 place) const { return camera.pixel(place, size); }

  /// Whether a place lies in the picture, within the field stop of an endoscope, and not under an inset.
  bool shows(PixelPoint at) const;
};

/// Where matter of a wall is, metres.
struct MaterialPlace {
  Vector3 now = {};
  Vector3 at_rest = {};  // on the stress-free wall
};

/// Of the matter that is nearest to `at` on a body's stress-free wall; nothing without such a body.
std::optional<MaterialPlace> material_place(const Snapshot& snapshot, const std::string& body, const Double3& at);

/// Outlines of tools: vertices and points along their rods.
std::vector<PixelPoint> tool_obstacles(const AnnotationScene& scene, const std::vector<ToolShape>& tools);

/// Where the camera is at `time`, but for a point that it follows and walls that grow: decides sides and order once for
/// all.
Camera resting_camera_at(const AnnotationScene& scene, double time);

/// Whether a place, at rest, lies left of the middle of the organs when it is first shown.
bool is_left_of_middle(const AnnotationScene& scene, Vector3 at_rest, double first_shown);

/// Between title and panels, and above captions that stand above these.
Box label_bounds(const AnnotationScene& scene);

/// What an inset, a legend and captions take.
std::vector<Box> taken_in(const AnnotationScene& scene);

void draw_plate(const Canvas& canvas, const AnnotationScene& scene, const Text& text, const Box& box);

}  // namespace thinwall
