#pragma once

#include <string>
#include <vector>

namespace thinwall {

/// How two sequences of frames differ in length, told by the hashes of the frames: "148 frames instead of 150: frames
/// 12 to 13 are missing, all others are equal". Empty when they are of one length.
std::string length_difference(const std::vector<std::string>& first, const std::vector<std::string>& second);

}  // namespace thinwall
