#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// Width and height of a PNG picture when all parts are there, from IHDR to IEND, with at least one of IDAT, and their
/// checksums are right (PNG specification, ISO/IEC 15948, section 5); its pixels are not decoded. Nothing for
/// animations, for more than 64 million pixels, and for what is no such file.
std::optional<ImageSize> size_of_whole_png(const std::string& bytes);

/// The same picture without the part that names a gamma (gAMA): libpng would bring its numbers to sRGB. What stands
/// behind a part that is cut short stays as it is.
std::vector<std::uint8_t> without_gamma(std::span<const std::uint8_t> bytes);

/// Whether the parts reach the end mark (IEND), and it is whole. What stands behind it is not looked at.
bool has_png_end(std::span<const std::uint8_t> bytes);

}  // namespace thinwall
