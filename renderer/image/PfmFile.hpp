#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "renderer/image/FloatImage.hpp"

namespace thinwall {

/// Whether the bytes begin as a portable float map of three channels or one.
bool is_pfm(std::span<const std::uint8_t> bytes);

/// The numbers of a portable float map, either byte order, to the last bit; its rows are stored from the lowest up.
/// `name` is for the message only. Throws ImageUnreadable: header that makes no sense, cut short, too large.
FloatImage decode_pfm(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace thinwall
