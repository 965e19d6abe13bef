#pragma once

#include "renderer/image/Image.hpp"

namespace thinwall {

/// Whether captions of pictures of `size` stand above the panels for want of width between them. There an inset in a
/// lower corner would have their place, and they would stand above it, over the action.
bool captions_stand_above_panels(ImageSize size);

}  // namespace thinwall
