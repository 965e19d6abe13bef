#pragma once

#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/image/Image.hpp"

namespace thinwall {

/// The widest vertical field of view, at most `wanted` (radians, above 0 and below pi), of which a camera of `kind`
/// with such a lens makes a whole picture of `size`: `wanted` itself, unless the lens folds the picture over before its
/// border, where behind_the_lens throws.
double unfolded_field_of_view(CameraKind kind, const LensDistortion& lens, double wanted, ImageSize size);

}  // namespace thinwall
