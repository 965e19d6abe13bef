#pragma once

#include <vector>

#include "renderer/annotation/Annotation.hpp"
#include "renderer/annotation/AnnotationScene.hpp"

namespace thinwall {

/// Draws the labels that are shown, with lines to what they point at. Gives where plates and dots are, for other texts
/// to keep clear of.
std::vector<Box> draw_labels(const Canvas& canvas, const AnnotationScene& scene,
                             const std::vector<LabelDefinition>& labels);

}  // namespace thinwall
