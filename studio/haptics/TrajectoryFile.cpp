#include "studio/haptics/TrajectoryFile.hpp"

#include <fmt/format.h>

#include "engine/haptics/HapticDevice.hpp"
#include "studio/organs/CsvTable.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {

std::vector<TimedPose> read_trajectory(const std::filesystem::path& file, const ToolPose& frame) {
  std::vector<CsvColumn> columns;
  try {
    columns = read_csv_columns(file, {"time_s", "x_m", "y_m", "z_m"});
  } catch (const FileFormatError& error) {
    throw InputErrors({{error.location(), error.what()}});
  }
  const CsvColumn& times = columns[0];
  if (times.values.empty()) throw InputErrors({{SourceLocation{.file = file}, "the table has no rows"}});
  std::vector<TimedPose> moments;
  for (std::size_t row = 0; row < times.values.size(); ++row) {
    if (row > 0 && times.values[row] <= times.values[row - 1]) {
      throw InputErrors({{SourceLocation{.file = file, .line = times.lines[row], .column = times.columns[row]},
                          "time_s: times ascend from row to row; a table of several tools has to be parted"}});
    }
    TimedPose moment{.time = times.values[row] - times.values[0], .pose = frame};
    moment.pose.tip = {columns[1].values[row], columns[2].values[row], columns[3].values[row]};
    if (moment.pose.tip.norm() > kFarthestHand) {
      throw InputErrors(
          {{SourceLocation{.file = file, .line = columns[1].lines[row], .column = columns[1].columns[row]},
            fmt::format("x_m, y_m, z_m: no hand is farther than {:g} m from the scene's origin; the table "
                        "is in metres",
                        kFarthestHand)}});
    }
    moments.push_back(moment);
  }
  return moments;
}

}  // namespace thinwall
