#include "studio/director/CutCheck.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

Clip piercing_of(const std::string& body) {
  PierceClip pierce;
  pierce.body = body;
  return {.action = pierce, .number = 2};
}

/// What is said of clips on a sheet of these triangles over five corners; empty when nothing is.
std::string told_of(const std::vector<Eigen::Vector3i>& triangles, const Clip& clip) {
  const std::vector<Clip> timeline = {Clip{.action = WaitClip{}}, clip};
  BodyDefinition sheet{.name = "sheet"};
  sheet.mesh.vertices = {{0, 0, 0}, {1e-3, 0, 0}, {1e-3, 1e-3, 0}, {-1e-3, 0, 0}, {-1e-3, -1e-3, 0}};
  sheet.mesh.triangles = triangles;
  try {
    refuse_uncuttable(timeline, sheet);
  } catch (const InputErrors& refusal) {
    return refusal.what();
  }
  return "";
}

const std::vector<Eigen::Vector3i> kTouching = {{0, 1, 2}, {0, 3, 4}};

TEST(CutCheck, TellsWhereAWallThatIsToBeCutIsNoManifold) {
  const std::string touching = told_of(kTouching, piercing_of("sheet"));
  EXPECT_NE(touching.find("timeline[2].pierce: the wall of body `sheet` cannot be cut, as it has 1 vertex in which "
                          "parts of it touch: (0, 0, 0), in mm; "),
            std::string::npos)
      << touching;
  const Clip incision{.action = InciseClip{.body = "sheet"}, .number = 2};
  const std::string crowded = told_of({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, incision);
  EXPECT_NE(crowded.find("timeline[2].incise: the wall of body `sheet` cannot be cut, as it has 1 edge shared by more "
                         "than two triangles: (0, 0, 0) to (1, 0, 0), in mm; "),
            std::string::npos)
      << crowded;
  const std::string contrary = told_of({{0, 1, 2}, {0, 1, 3}}, incision);
  EXPECT_NE(contrary.find("1 edge between triangles that face opposite ways: (0, 0, 0) to (1, 0, 0), in mm; "),
            std::string::npos)
      << contrary;
}

TEST(CutCheck, LeavesManifoldsAndWallsThatNothingCutsAlone) {
  EXPECT_EQ(told_of({{0, 1, 2}, {1, 0, 3}}, piercing_of("sheet")), "");
  EXPECT_EQ(told_of(kTouching, piercing_of("other")), "");
  EXPECT_EQ(told_of(kTouching, {.action = PalpateClip{.body = "sheet"}}), "");
}

}  // namespace
}  // namespace thinwall
