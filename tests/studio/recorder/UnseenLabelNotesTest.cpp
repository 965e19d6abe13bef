#include "studio/recorder/UnseenLabelNotes.hpp"

#include <gtest/gtest.h>

#include "tests/studio/recorder/LevelWall.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kLabelPicture{640, 360};

Snapshot labelled_wall() {
  return level_wall(0.05F, 0.05F);
}

/// The wall moves 20 mm to the right at each second.
Snapshot labelled_wall_at(double time) {
  Snapshot snapshot = labelled_wall();
  snapshot.time = time;
  for (Float3& position : snapshot.surfaces[0].positions) position[0] += static_cast<float>(0.02 * time);
  return snapshot;
}

/// From above, of a square of some 40 mm about the origin.
const Shot kShotOfMiddle = shot_from({0, -0.001, 0.1}, {0, 0, 0});

std::vector<std::string> label_notes(const LabelDefinition& label, const Shot& shot = kShotOfMiddle) {
  UnseenLabelNotes notes({{.text = "Middle", .body = "wall"}, label});
  for (const double time : {0.0, 1.0, 2.0}) notes.see(labelled_wall_at(time), shot, kLabelPicture);
  return notes.notes();
}

TEST(UnseenLabelNotes, TellOfALabelWhosePointNoPictureShows) {
  EXPECT_EQ(label_notes({.text = "Border", .body = "wall", .at = {0, 0.05, 0}}),
            std::vector<std::string>{
                "teaching.labels[2]: \"Border\" is in no picture: the place of body `wall` that is nearest to its `at` "
                "lies beside all of them; set `at` to a place that the camera sees, or the camera so that it sees this "
                "one"});
  EXPECT_TRUE(label_notes({.text = "Border", .body = "wall", .at = {0.005, 0, 0}}).empty());
}

TEST(UnseenLabelNotes, OnePictureThatShowsThePointIsEnough) {
  const LabelDefinition left{.text = "Left", .body = "wall", .at = {-0.05, 0, 0}};
  LabelDefinition early = left, late = left;
  early.span = {.begin = 0, .end = 0.5};
  late.span = {.begin = 1.5};
  EXPECT_TRUE(label_notes(left).empty()) << "the wall brings it into the picture";
  EXPECT_FALSE(label_notes(early).empty()) << "it is there no more when the picture shows it";
  EXPECT_TRUE(label_notes(late).empty());
}

TEST(UnseenLabelNotes, NothingIsToldOfLabelsOfNoPictureOrOfASplitScreen) {
  LabelDefinition border{.text = "Border", .body = "wall", .at = {0, 0.05, 0}};
  Shot beside = kShotOfMiddle;
  beside.beside = shot_from({0, 0.04, 0.1}, {0, 0.05, 0}).camera;
  EXPECT_TRUE(label_notes(border, beside).empty());
  border.span = {.begin = 5};
  EXPECT_TRUE(label_notes(border).empty()) << "that its time is past the end is told elsewhere";
}

}  // namespace
}  // namespace thinwall
