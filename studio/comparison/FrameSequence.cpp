#include "studio/comparison/FrameSequence.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace thinwall {
namespace {

/// Which frames the longer one has besides those of the shorter one: "frames 12 to 13 are", "frames 0 to 4 at the
/// beginning are". Empty where others differ too.
std::string frames_besides(const std::vector<std::string>& longer, const std::vector<std::string>& shorter) {
  std::size_t begin = 0;
  while (begin < shorter.size() && longer[begin] == shorter[begin]) ++begin;
  const std::size_t count = longer.size() - shorter.size();
  const bool rest_is_equal = std::equal(shorter.begin() + static_cast<std::ptrdiff_t>(begin), shorter.end(),
                                        longer.begin() + static_cast<std::ptrdiff_t>(begin + count));
  if (!rest_is_equal) return "";
  const char* where = begin == 0 ? " at the beginning" : begin == shorter.size() ? " at the end" : "";
  if (count == 1) return fmt::format("frame {}{} is", begin, where);
  return fmt::format("frames {} to {}{} are", begin, begin + count - 1, where);
}

}  // namespace

std::string length_difference(const std::vector<std::string>& first, const std::vector<std::string>& second) {
  if (first.size() == second.size()) return "";
  std::string sentence = fmt::format("{} frames instead of {}", second.size(), first.size());
  const bool is_shorter = second.size() < first.size();
  const std::string which = is_shorter ? frames_besides(first, second) : frames_besides(second, first);
  if (!which.empty()) sentence += ": " + which + (is_shorter ? " missing" : " new") + ", all others are equal";
  return sentence;
}

}  // namespace thinwall
