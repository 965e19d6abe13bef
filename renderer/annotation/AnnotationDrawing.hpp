#pragma once

#include <optional>

#include "renderer/annotation/Annotation.hpp"
#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/camera/PictureLayout.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/overlay/Box.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Writes labels and arrows over the part of a picture that `camera` has filled with `snapshot`. Labels stand beside
/// organ and tools where there is room, between title and panels, and keep their side and order while they are shown.
/// Points that a wall hides have a hollow dot; what is behind the camera or outside the picture is left out. Drawn on
/// the processor like the overlays; a pure function of the arguments. `inset`: the part of the whole picture that a
/// small one covers; nothing is drawn on it, and what lies under it is left out. `taken`: parts of the whole picture
/// where a legend or captions of halves stand, which labels and texts keep clear of.
void draw_annotations(Image& image, const PictureBox& box, const AnnotationDefinition& annotations,
                      const Snapshot& snapshot, const CameraDefinition& camera,
                      const std::optional<PictureBox>& inset = {}, const std::vector<Box>& taken = {});

/// Whether a whole picture has in it what a label points at, be it behind a wall: what it does not have has no label.
bool shows_point_of(const LabelDefinition& label, const Snapshot& snapshot, const CameraDefinition& camera,
                    ImageSize size);

/// Whether the force on its tool makes a force arrow long enough to be drawn in a whole picture; none where there is no
/// force, or the tool's tip lies beside the picture.
std::optional<bool> shows_force_arrow(const ForceArrowDefinition& arrow, const Snapshot& snapshot,
                                      const CameraDefinition& camera, ImageSize size);

}  // namespace thinwall
