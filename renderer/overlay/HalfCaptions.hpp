#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/overlay/Box.hpp"

namespace thinwall {

/// What the left and the right half of a picture show, each at the left of its half below the title, where it does not
/// cover what happens in the middle unless the text needs that room; a mark beside the text has the colour of the
/// half's curve in the force plot. And a line between the halves. Below an `inset` that has their place. Throws
/// PictureFailure when the font is missing.
void draw_half_captions(Image& image, const std::array<std::string, 2>& captions, const std::optional<Box>& inset = {});

/// Where the plates of the captions are in a picture of that size; none that finds no room. Throws PictureFailure
/// likewise.
std::vector<Box> half_caption_places(ImageSize size, const std::array<std::string, 2>& captions,
                                     const std::optional<Box>& inset = {});

}  // namespace thinwall
