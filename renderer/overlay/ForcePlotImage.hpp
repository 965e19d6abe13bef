#pragma once

#include <array>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// A row of the force record.
struct ForcePoint {
  double time = 0;                // seconds
  std::array<double, 3> force{};  // newton, x y z, what the tissue does to the tool
  double depth = 0;               // metres since first contact
  std::string phase;
};

struct ToolForces {
  std::string tool;
  std::vector<ForcePoint> points;  // ascending in time
};

/// The page `forces.png`: force and its components against time over the tools' phases, and force against depth. All
/// numbers must be finite; without any points the page says so. Throws PictureFailure when the font is missing.
Image force_plot_image(const std::string& title, const std::vector<ToolForces>& tools, ImageSize size = {1600, 900});

}  // namespace thinwall
