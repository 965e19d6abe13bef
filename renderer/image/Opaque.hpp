#pragma once

#include <cstddef>
#include <cstdint>

namespace thinwall {

/// RGBA to RGB: (4 x pixels) to (3 x pixels).
void leave_out_alpha(const std::uint8_t* from, std::uint8_t* to, std::size_t pixels);

}  // namespace thinwall
