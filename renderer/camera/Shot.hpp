#pragma once

#include "renderer/camera/View.hpp"

namespace thinwall {

/// What the view's cuts show at `time` (seconds): that of the last cut up to then, the main camera before the first.
/// Throws PictureFailure when a cut names a camera that the view lacks.
Shot shot_at(const ViewDefinition& view, double time);

}  // namespace thinwall
