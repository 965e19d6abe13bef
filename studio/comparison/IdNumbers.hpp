#pragma once

#include <optional>
#include <utility>

#include "renderer/image/FloatImage.hpp"
#include "studio/comparison/PictureFile.hpp"

namespace thinwall {

/// The ids that two pictures hold, one for each pixel. Of grey ones the number itself, of 16 bits where either has
/// such; of colours of 8 bits, which ids are often kept as, one that is made of the three. Nothing where colours are
/// finer than that.
std::optional<std::pair<FloatImage, FloatImage>> id_numbers(const MediaFile& first, const MediaFile& second);

}  // namespace thinwall
