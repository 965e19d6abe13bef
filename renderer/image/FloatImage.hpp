#pragma once

#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// A picture of numbers: linear light of high range, or a layer of ground truth such as depth, normals or flow. First
/// row on top. Not-a-number and infinity may occur; what they mean is said where they may.
struct FloatImage {
  ImageSize size;
  int channels = 3;
  std::vector<float> values;  // (height x width x channels)
};

}  // namespace thinwall
