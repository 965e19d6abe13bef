#include "studio/haptics/CoarseScenario.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

Scenario with(std::variant<MeshFileSource, ShapeSource> surface) {
  Scenario scenario;
  scenario.bodies.push_back({.name = "organ"});
  scenario.bodies.back().surface = std::move(surface);
  return scenario;
}

int triangles_of(const Scenario& scenario) {
  return std::get<ShapeSource>(scenario.bodies[0].surface).triangles;
}

TEST(CoarseScenario, GivesShapesOfManyTrianglesFewer) {
  const auto coarse = coarse_scenario(with(ShapeSource{.radius = 0.03, .triangles = 10000}), 2500);
  ASSERT_TRUE(coarse);
  EXPECT_EQ(triangles_of(*coarse), 2500);
  EXPECT_EQ(std::get<ShapeSource>(coarse->bodies[0].surface).radius, 0.03);
}

TEST(CoarseScenario, IsNoneWhereNoShapeHasFarMoreTriangles) {
  EXPECT_FALSE(coarse_scenario(with(ShapeSource{.triangles = 3000}), 2500));
}

TEST(CoarseScenario, IsNoneWhereAWallIsReadFromAFile) {
  EXPECT_FALSE(coarse_scenario(with(MeshFileSource{.file = "organ.obj"}), 2500));
}

TEST(CoarseScenario, LeavesASmallBodyBesideALargeOneAsItIs) {
  Scenario scenario = with(ShapeSource{.triangles = 256});
  scenario.bodies.push_back(with(ShapeSource{.triangles = 20000}).bodies[0]);
  const auto coarse = coarse_scenario(scenario, 2500);
  ASSERT_TRUE(coarse);
  EXPECT_EQ(triangles_of(*coarse), 256);
}

TEST(AffordableTriangles, AreAllWhereTheWallAnswersInTime) {
  EXPECT_EQ(affordable_triangles(2100, 1e-3, 3e-3), 2100);
  EXPECT_EQ(affordable_triangles(2100, 3e-3, 3e-3), 2100);
}

TEST(AffordableTriangles, AreFewerAsTheWallAnswersLate) {
  EXPECT_EQ(affordable_triangles(2100, 6e-3, 3e-3), 1050);
}

TEST(AffordableTriangles, AreEnoughForATipAndNeverMoreThanBefore) {
  EXPECT_EQ(affordable_triangles(2100, 1, 3e-3), 900);
  EXPECT_EQ(affordable_triangles(300, 1, 3e-3), 300);
}

}  // namespace
}  // namespace thinwall
