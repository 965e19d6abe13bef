#include "studio/haptics/TrajectoryFile.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "studio/scenario/InputError.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

TEST(TrajectoryFileTest, TheForcesOfARunAreAMotion) {
  const TemporaryFolder folder;
  write_bytes(folder / "forces.csv",
              "time_s,tool,phase,x_m,y_m,z_m,depth_m\n1,probe,idle,0.1,0.2,0.3,0\n1.5,probe,hold,0.1,0.2,0.4,0\n");
  ToolPose frame;
  frame.direction = -Eigen::Vector3d::UnitX();
  const std::vector<TimedPose> moments = read_trajectory(folder / "forces.csv", frame);
  ASSERT_EQ(moments.size(), 2U);
  EXPECT_EQ(moments[0].time, 0);
  EXPECT_EQ(moments[1].time, 0.5);
  EXPECT_EQ(moments[1].pose.tip, Eigen::Vector3d(0.1, 0.2, 0.4));
  EXPECT_EQ(moments[1].pose.direction, frame.direction);
}

/// What is said of a table that is refused.
std::string refusal_of(const std::filesystem::path& file) {
  try {
    read_trajectory(file, {});
  } catch (const InputErrors& errors) {
    return errors.what();
  }
  return "it was taken";
}

TEST(TrajectoryFileTest, TimesThatDoNotAscendAndPlacesThatNoHandReachesAreToldWithTheirPlace) {
  const TemporaryFolder folder;
  write_bytes(folder / "two.csv", "time_s,x_m,y_m,z_m\n0,0,0,0\n0,1,1,1\n");
  EXPECT_NE(refusal_of(folder / "two.csv").find("two.csv:3:1"), std::string::npos) << refusal_of(folder / "two.csv");
  write_bytes(folder / "far.csv", "time_s,x_m,y_m,z_m\n0,0,0,0\n1,0,25,0\n");
  EXPECT_NE(refusal_of(folder / "far.csv").find("far.csv:3:3"), std::string::npos) << refusal_of(folder / "far.csv");
  write_bytes(folder / "none.csv", "time_s,x_m,y_m,z_m\n");
  EXPECT_THROW(read_trajectory(folder / "none.csv", {}), InputErrors);
  EXPECT_THROW(read_trajectory(folder / "missing.csv", {}), InputErrors);
}

}  // namespace
}  // namespace thinwall
