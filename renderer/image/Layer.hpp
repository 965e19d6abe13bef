#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// A picture of numbers that are no colours, first row on top.
template <typename Number>
struct Layer {
  ImageSize size;
  std::size_t channels = 1;
  std::vector<Number> values;  // (height x width x channels)
};

using ByteLayer = Layer<std::uint8_t>;
using WordLayer = Layer<std::uint16_t>;
using FloatLayer = Layer<float>;

}  // namespace thinwall
