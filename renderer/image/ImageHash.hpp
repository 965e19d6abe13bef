#pragma once

#include <string>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// 32 hexadecimal digits: XXH3 (128 bits) of width, height (little-endian 32-bit) and the pixels. Equal pictures and
/// only they have equal hashes, apart from chance; not meant against forgery.
std::string image_hash(const Image& image);

}  // namespace thinwall
