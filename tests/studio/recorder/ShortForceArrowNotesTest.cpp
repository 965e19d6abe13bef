#include "studio/recorder/ShortForceArrowNotes.hpp"

#include <gtest/gtest.h>

#include "tests/studio/recorder/LevelWall.hpp"

namespace thinwall {
namespace {

/// Of a probe whose force grows to `most` (newton) in two seconds, from the side, some 60 mm high.
std::vector<std::string> arrow_notes(const ForceArrowDefinition& arrow, double most,
                                     const Shot& shot = shot_from({0, -0.11, 0.01}, {0, 0, 0.01})) {
  ShortForceArrowNotes notes({arrow});
  for (const double time : {0.0, 1.0, 2.0}) {
    Snapshot snapshot = level_wall(0.05F, 0.05F);
    snapshot.time = time;
    snapshot.tools = {{.name = "probe", .force = {0, 0, 0.5 * time * most}}};
    notes.see(snapshot, shot, {640, 360});
  }
  return notes.notes();
}

TEST(ShortForceArrowNotes, TellOfAnArrowThatItsForcesNeverMakeLongEnough) {
  // 10 units of 720 are 0.8 mm here, which is the arrow of 0.055 N.
  const ForceArrowDefinition arrow{.tool = "probe", .full = 1, .length = 0.015};
  EXPECT_EQ(
      arrow_notes(arrow, 0.04),
      std::vector<std::string>{
          "teaching.force_arrows[1]: is in no picture: the force of tool `probe`, 0.04 N at most, makes it too short "
          "to be drawn; a smaller `full` than 1 N, or a larger `length`, shows it"});
  EXPECT_TRUE(arrow_notes(arrow, 0.07).empty()) << "one picture that shows it is enough";
  EXPECT_TRUE(arrow_notes({.tool = "probe", .full = 0.2, .length = 0.015}, 0.04).empty());
}

TEST(ShortForceArrowNotes, NothingIsToldWithoutAForceBesideThePictureOrOfASplitScreen) {
  const ForceArrowDefinition arrow{.tool = "probe", .full = 1, .length = 0.015};
  EXPECT_TRUE(arrow_notes(arrow, 0).empty());
  EXPECT_TRUE(arrow_notes({.tool = "probe", .full = 1, .length = 0.015, .span = {.begin = 3}}, 0.04).empty());
  EXPECT_TRUE(arrow_notes(arrow, 0.04, shot_from({0, -0.11, 0.5}, {0, 0, 0.5})).empty());
  Shot split = shot_from({0, -0.11, 0.01}, {0, 0, 0.01});
  split.beside = split.camera;
  EXPECT_TRUE(arrow_notes(arrow, 0.04, split).empty());
}

}  // namespace
}  // namespace thinwall
