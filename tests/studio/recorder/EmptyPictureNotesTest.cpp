#include "studio/recorder/EmptyPictureNotes.hpp"

#include <gtest/gtest.h>

#include "tests/studio/recorder/LevelWall.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{640, 360};

Snapshot wall() {
  return level_wall(0.05F, 0.05F);
}

std::vector<std::string> notes_of(const std::vector<Shot>& shots) {
  EmptyPictureNotes notes;
  for (const Shot& shot : shots) notes.see(wall(), shot, kSize);
  return notes.notes();
}

const std::string kCure = "; without `position` and `target` the bodies fill the picture";

TEST(EmptyPictureNotes, TellThatTheCameraLooksPastTheBodies) {
  const std::vector<std::string> expected = {"camera: no picture shows anything of a body" + kCure};
  EXPECT_EQ(notes_of({shot_from({0, -0.2, 0.1}, {0, -0.4, 0.1})}), expected) << "they are behind it";
  EXPECT_EQ(notes_of({shot_from({0, -0.2, 0.1}, {0.5, 0, 0.1})}), expected) << "they are beside it";
  EXPECT_TRUE(notes_of({}).empty()) << "there is no picture";
}

TEST(EmptyPictureNotes, TellThatTheBodiesAreSpecks) {
  EXPECT_EQ(notes_of({shot_from({0, -200, 100}, {0, 0, 0})}),
            std::vector<std::string>{
                "camera: in all pictures the bodies are specks; see whether the unit of `position` is meant" + kCure});
}

TEST(EmptyPictureNotes, OnePictureThatShowsABodyIsEnough) {
  const Shot past = shot_from({0, -0.2, 0.1}, {0, -0.4, 0.1});
  EXPECT_TRUE(notes_of({past, shot_from({0, -0.2, 0.1}, {0, 0, 0}), past}).empty());
  EXPECT_TRUE(notes_of({shot_from({0, 0, 0.001}, {0, 1, 0.001})}).empty()) << "the camera is among the vertices";
  Shot beside = past;
  beside.beside = shot_from({0, -0.2, 0.1}, {0, 0, 0}).camera;
  EXPECT_TRUE(notes_of({beside}).empty());
}

}  // namespace
}  // namespace thinwall
