#include "studio/organs/SpanWords.hpp"

#include <fmt/core.h>

namespace thinwall {

std::string span_words(const Eigen::AlignedBox3d& box) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    // A zero is added because fmt writes a negative one with its sign.
    text += fmt::format("{}{} {:.4g} ... {:.4g}", axis == 0 ? "" : ", ", "xyz"[axis], 1e3 * box.min()[axis] + 0.0,
                        1e3 * box.max()[axis] + 0.0);
  }
  return text + " mm";
}

}  // namespace thinwall
