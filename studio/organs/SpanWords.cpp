#include "studio/organs/SpanWords.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

constexpr int kDigits = 4, kMostDigits = 15;  // significant ones

/// So many that far from the origin the ends still differ.
int digits_of(const Eigen::AlignedBox3d& box) {
  const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double longest = box.sizes().maxCoeff();
  if (!(farthest > longest) || !(longest > 0)) return kDigits;
  return std::min(kDigits + static_cast<int>(std::log10(farthest / longest)), kMostDigits);
}

}  // namespace

std::string span_words(const Eigen::AlignedBox3d& box) {
  const int digits = digits_of(box);
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    // A zero is added because fmt writes a negative one with its sign.
    text += fmt::format("{}{} {:.{}g} ... {:.{}g}", axis == 0 ? "" : ", ", "xyz"[axis], 1e3 * box.min()[axis] + 0.0,
                        digits, 1e3 * box.max()[axis] + 0.0, digits);
  }
  return text + " mm";
}

}  // namespace thinwall
