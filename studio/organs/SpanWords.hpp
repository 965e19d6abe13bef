#pragma once

#include <Eigen/Geometry>
#include <string>

namespace thinwall {

/// From where to where something reaches, "x -20 ... 20, y -20 ... 20, z 0 ... 20 mm", to a hundredth of that or
/// nearer, however far off it lies. `box`: metres, not empty.
std::string span_words(const Eigen::AlignedBox3d& box);

}  // namespace thinwall
