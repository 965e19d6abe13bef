#pragma once

#include <vector>

#include "renderer/annotation/Annotation.hpp"
#include "renderer/annotation/AnnotationScene.hpp"

namespace thinwall {

/// Draws the labels that are shown: their lines to what they point at on `lines`, plates and dots on `canvas`, which
/// comes over that. Gives where plates and dots are, for other texts to keep clear of.
std::vector<Box> draw_labels(const Canvas& lines, const Canvas& canvas, const AnnotationScene& scene,
                             const std::vector<LabelDefinition>& labels);

}  // namespace thinwall
