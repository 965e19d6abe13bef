#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "renderer/annotation/Annotation.hpp"
#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/camera/PictureLayout.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/overlay/Box.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

class Canvas;

/// Labels and arrows over the part of a picture that `camera` has filled with `snapshot`. Labels stand beside
/// organ and tools where there is room, between title and panels, and keep their side and order while they are shown.
/// Points that a wall hides have a hollow dot; what is behind the camera or outside the picture is left out. Drawn on
/// the processor like the overlays; a pure function of the arguments.
class AnnotationLayers {
 public:
  /// `size`: of the whole picture, `box`: the part of it. `inset`: the part of the whole picture that a small one
  /// covers; nothing is drawn on it, and what lies under it is left out. `taken`: parts of the whole picture where a
  /// legend or captions of halves stand, which labels and texts keep clear of.
  AnnotationLayers(ImageSize size, const PictureBox& box, const AnnotationDefinition& annotations,
                   const Snapshot& snapshot, const CameraDefinition& camera,
                   const std::optional<PictureBox>& inset = {}, const std::vector<Box>& taken = {});

  ~AnnotationLayers();
  AnnotationLayers(AnnotationLayers&&) noexcept;

  /// The lines of labels, for titles, captions and panels to be written over.
  void lay_lines(Image& image) const;

  /// All else, to be seen over these: what is pointed at may lie where they stand.
  void lay_points(Image& image) const;

 private:
  PictureBox box_;
  std::unique_ptr<Canvas> lines_;
  std::unique_ptr<Canvas> points_;
};

/// Whether a whole picture has in it what a label points at, be it behind a wall: what it does not have has no label.
bool shows_point_of(const LabelDefinition& label, const Snapshot& snapshot, const CameraDefinition& camera,
                    ImageSize size);

/// Whether the force on its tool makes a force arrow long enough to be drawn in a whole picture; none where there is no
/// force, or the tool's tip lies beside the picture.
std::optional<bool> shows_force_arrow(const ForceArrowDefinition& arrow, const Snapshot& snapshot,
                                      const CameraDefinition& camera, ImageSize size);

}  // namespace thinwall
