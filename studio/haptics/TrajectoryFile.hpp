#pragma once

#include <filesystem>
#include <vector>

#include "engine/haptics/Trajectory.hpp"

namespace thinwall {

/// A motion of a hand from a table with the columns `time_s`, `x_m`, `y_m`, `z_m` (others count for nothing, so that
/// the forces.csv of a run with one tool will do), its first moment at time zero. `frame`: whose direction, axis and
/// opening the tool keeps. Throws InputErrors.
std::vector<TimedPose> read_trajectory(const std::filesystem::path& file, const ToolPose& frame);

}  // namespace thinwall
