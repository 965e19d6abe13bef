#include "studio/recorder/FarPlaces.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

Scenario with_places(const Double3& at) {
  Scenario scenario;
  scenario.teaching.annotations.labels = {{.body = "organ", .at = at}};
  scenario.teaching.annotations.arrows = {{.body = "organ", .at = at}};
  scenario.view.highlights = {{.body = "organ", .center = at, .radius = 0.005}};
  scenario.record.points = {{.name = "crown", .body = "organ", .at = {at[0], at[1], at[2]}}};
  return scenario;
}

Snapshot ball() {
  Snapshot snapshot;
  snapshot.surfaces.push_back(test::sphere("organ", {0, 0, 0}, 0.02, 3));
  return snapshot;
}

TEST(FarPlaces, AWrongUnitIsToldWithHowFarItLeads) {
  const std::string off = ": it lies 180 mm off the stress-free body `organ`, ";
  EXPECT_EQ(far_places(with_places({0, 0, 0.2}), ball()),
            (std::vector<std::string>{"teaching.labels[1].at" + off + "the nearest place of its wall is taken",
                                      "teaching.arrows[1].at" + off + "the nearest place of its wall is taken",
                                      "teaching.highlights[1].at" + off + "the ball of 5 mm meets no wall",
                                      "record.points.crown.at" + off + "the nearest place of its wall is taken"}));
}

TEST(FarPlaces, PlacesNearTheWallAreNotTold) {
  EXPECT_TRUE(far_places(with_places({0, 0, 0.023}), ball()).empty());
}

TEST(FarPlaces, AHighlightBesideTheWallMarksNothing) {
  const std::vector<std::string> notes = far_places(with_places({0, 0, 0.03}), ball());
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].find("teaching.highlights[1].at: it lies 10 mm off"), 0U) << notes[0];
}

}  // namespace
}  // namespace thinwall
