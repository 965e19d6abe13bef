#include "studio/comparison/FrameSequence.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace thinwall {
namespace {

/// Where frames are missing in the shorter one, when all others are the same: "frames 12 to 13 are missing"
std::string missing_frames(const std::vector<std::string>& longer, const std::vector<std::string>& shorter) {
  std::size_t begin = 0;
  while (begin < shorter.size() && longer[begin] == shorter[begin]) ++begin;
  const std::size_t missing = longer.size() - shorter.size();
  const bool rest_is_equal = std::equal(shorter.begin() + static_cast<std::ptrdiff_t>(begin), shorter.end(),
                                        longer.begin() + static_cast<std::ptrdiff_t>(begin + missing));
  if (!rest_is_equal) return "";
  if (missing == 1) return fmt::format("frame {} is missing, all others are equal", begin);
  return fmt::format("frames {} to {} are missing, all others are equal", begin, begin + missing - 1);
}

}  // namespace

std::string length_difference(const std::vector<std::string>& first, const std::vector<std::string>& second) {
  if (first.size() == second.size()) return "";
  std::string sentence = fmt::format("{} frames instead of {}", second.size(), first.size());
  const bool is_shorter = second.size() < first.size();
  const std::string where = is_shorter ? missing_frames(first, second) : missing_frames(second, first);
  if (!where.empty()) sentence += is_shorter ? ": " + where : ": in the first, " + where;
  return sentence;
}

}  // namespace thinwall
