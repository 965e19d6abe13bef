#pragma once

#include <cmath>

#include "renderer/annotation/AnnotationDrawing.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {

inline constexpr ImageSize kSize{1280, 720};

/// An organ, stretched along x, with a probe on its top that feels 0.5 N.
inline Snapshot scene(double stretch = 1) {
  Snapshot snapshot;
  snapshot.surfaces.push_back(test::sphere("organ", {0, 0, 0}, 0.02, 3));
  for (Float3& position : snapshot.surfaces[0].positions) position[0] *= static_cast<float>(stretch);
  SnapshotTool& tool = snapshot.tools.emplace_back();
  tool.name = "probe";
  tool.tip = {0, 0, 0.02};
  tool.force = {0, 0, 0.5};
  return snapshot;
}

inline CameraDefinition from_the_front() {
  CameraDefinition camera;
  camera.position = Double3{0, -0.12, 0};
  camera.target = Double3{0, 0, 0};
  return camera;
}

inline Image black() {
  return {.size = kSize, .pixels = std::vector<std::uint8_t>(3UL * kSize.width * kSize.height, 0)};
}

/// Red at a place, pixels from the top left.
inline int level(const Image& image, double x, double y) {
  const auto pixel = static_cast<std::size_t>(std::lround(y - 0.5)) * static_cast<std::size_t>(kSize.width) +
                     static_cast<std::size_t>(std::lround(x - 0.5));
  return image.pixels[3 * pixel];
}

/// As in a picture without title, captions and panels.
inline void draw_annotations(Image& image, const PictureBox& box, const AnnotationDefinition& annotations,
                             const Snapshot& snapshot, const CameraDefinition& camera,
                             const std::optional<PictureBox>& inset = {}, const std::vector<Box>& taken = {}) {
  const AnnotationLayers layers(image.size, box, annotations, snapshot, camera, inset, taken);
  layers.lay_lines(image);
  layers.lay_points(image);
}

/// Over black, seen from the front.
inline Image drawn(const AnnotationDefinition& annotations, const Snapshot& snapshot) {
  Image image = black();
  draw_annotations(image, {.size = kSize}, annotations, snapshot, from_the_front());
  return image;
}

inline AnnotationDefinition label_at(Double3 at) {
  AnnotationDefinition annotations;
  annotations.labels.push_back({.text = "Fundus", .body = "organ", .at = at, .span = {.begin = 0.5, .end = 2}});
  return annotations;
}

}  // namespace thinwall
