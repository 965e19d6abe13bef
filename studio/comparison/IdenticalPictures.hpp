#pragma once

#include <filesystem>
#include <optional>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// The size of both pictures when both files are PNG pictures of the same bytes, whole by the checksum of each of their
/// parts: they need no decoding to be equal. Nothing otherwise, also for animations and for whatever looks odd.
std::optional<ImageSize> identical_pictures(const std::filesystem::path& first, const std::filesystem::path& second);

}  // namespace thinwall
