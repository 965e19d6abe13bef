#include "studio/recorder/PlotPoints.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

StepRecord step(double time, const std::vector<std::string>& tools, double force) {
  StepRecord record{.time = time, .tools = {}, .bodies = {}};
  for (const std::string& name : tools) {
    ToolRecord tool{.tool = name, .phase = "contact"};
    tool.force.z() = force;
    record.tools.push_back(tool);
  }
  return record;
}

std::vector<std::string> names_of(const std::vector<ToolForces>& forces) {
  std::vector<std::string> names;
  for (const ToolForces& tool : forces) names.push_back(tool.tool);
  return names;
}

TEST(PlotPoints, AStepThatIsThereAlreadyIsPassedOver) {
  PlotPoints points;
  for (const double time : {0.0, 0.01, 0.01, 0.02}) points.add(step(time, {"probe"}, 1));
  EXPECT_EQ(points.forces().at(0).points.size(), 3U) << "a slower take has one step for several of the other";
}

TEST(PlotPoints, ForcesOfTakesThatAreComparedHaveTheirCaptions) {
  using Names = std::vector<std::string>;
  const auto names = [](const Names& tools) {
    PlotPoints first, second;
    first.add(step(0, tools, 1));
    second.add(step(0, tools, 2));
    const std::vector<ToolForces> forces = compared_forces(first, second, {"soft", "stiff"});
    EXPECT_EQ(forces.front().points[0].force[2], 1);
    EXPECT_EQ(forces.back().points[0].force[2], 2);
    return names_of(forces);
  };
  EXPECT_EQ(names({"probe"}), (Names{"soft", "stiff"}));
  EXPECT_EQ(names({"probe", "blade"}), (Names{"probe, soft", "blade, soft", "probe, stiff", "blade, stiff"}));
}

}  // namespace
}  // namespace thinwall
