#include "studio/organs/ToldPlaces.hpp"

#include <fmt/core.h>

#include <cmath>

namespace thinwall {

std::string place_text(const Eigen::Vector3d& place) {
  // Rounding leaves -0 or 1e-17 where zero is meant.
  const auto tidy = [](double x) { return std::abs(x) < 1e-12 ? 0.0 : x; };
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", tidy(place[0]), tidy(place[1]), tidy(place[2]));
}

}  // namespace thinwall
