#pragma once

#include <string>
#include <vector>

namespace thinwall {

/// How the second of two sequences of frames differs in length from the first, told by the hashes of the frames: "148
/// frames instead of 150: frames 12 to 13 are missing, all others are equal", "7 frames instead of 5: frames 5 to 6 at
/// the end are new, ...". Missing frames count in the first, new ones in the second. Empty when they are of one length.
std::string length_difference(const std::vector<std::string>& first, const std::vector<std::string>& second);

}  // namespace thinwall
