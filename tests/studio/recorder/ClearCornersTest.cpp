#include "studio/recorder/ClearCorners.hpp"

#include <gtest/gtest.h>

#include "tests/studio/recorder/LevelWall.hpp"

namespace thinwall {
namespace {

// A level wall that fills the picture, seen from straight above: x to the right, y up.
constexpr Double3 kMiddle{0, 0, 0}, kUpperRight{0.07, 0.03, 0}, kUpperLeft{-0.07, 0.03, 0}, kLowerRight{0.07, -0.02, 0};

Snapshot wide_wall() {
  return level_wall(0.1F, 0.06F);
}

CameraDefinition from_above() {
  return {.position = Double3{0, 0, 0.2}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}};
}

/// A press there, from 1 s to 2 s.
PlannedWork press(Double3 place) {
  return {.tool = "probe",
          .body = "wall",
          .places = {place},
          .direction = Double3{0, 0, -1},
          .depth = 0.002,
          .begin = 1,
          .end = 2};
}

struct Recording {
  Snapshot first = wide_wall();
  ViewDefinition view = {};
  AnnotationDefinition annotations = {};
  std::vector<PlannedWork> work = {};
  OverlayContent legends = {};
  ImageSize size = {1280, 720};

  Recording() {
    view.camera = from_above();
    view.cameras["other"] = from_above();
  }
  void show_inset(double time) { view.cuts.push_back({.time = time, .inset = "other"}); }
  void show_legend() {
    view.look.data = DataView{};
    legends.legend = Legend{.title = "Stress", .unit = "Pa"};
  }
  ClearCorners corners() const {
    return ClearCorners({.first = first,
                         .view = view,
                         .annotations = annotations,
                         .work = work,
                         .size = size,
                         .end = 4,
                         .legends = legends});
  }
};

TEST(ClearCorners, AnInsetStaysAtTheUpperRightUntilItCoversWork) {
  Recording recording;
  recording.show_inset(0.5);
  recording.work = {press(kMiddle), press(kUpperLeft)};
  EXPECT_EQ(recording.corners().inset(1.5), PictureCorner::kUpperRight);
  recording.work = {press(kUpperRight)};
  EXPECT_EQ(recording.corners().inset(1.5), PictureCorner::kUpperLeft);
  recording.work = {press(kUpperRight), press(kUpperLeft)};
  EXPECT_EQ(recording.corners().inset(1.5), PictureCorner::kLowerRight);
  recording.work = {press(kUpperRight), press(kUpperLeft), press(kLowerRight)};
  EXPECT_EQ(recording.corners().inset(1.5), PictureCorner::kLowerLeft);
}

TEST(ClearCorners, AnInsetLeavesCaptionsTheirPlaceInNarrowPictures) {
  Recording recording;
  recording.size = {720, 720};
  recording.show_inset(0.5);
  // Half a picture is 54 mm wide and high there.
  recording.work = {press({0.04, 0.03, 0}), press({0.04, 0.03, 0}), press({-0.04, 0.03, 0})};
  EXPECT_EQ(recording.corners().inset(1.5), PictureCorner::kUpperLeft) << "not in a lower one, though that is clear";
}

TEST(ClearCorners, WhereAllCornersCoverWorkTheOneThatCoversLeastIsTaken) {
  Recording recording;
  recording.show_inset(0.5);
  const Double3 lower_left{-0.07, -0.02, 0};
  recording.work = {press(kUpperRight), press(kUpperRight), press(kUpperLeft), press(kUpperLeft),
                    press(kLowerRight), press(lower_left),  press(lower_left)};
  EXPECT_EQ(recording.corners().inset(1.5), PictureCorner::kLowerRight);
}

TEST(ClearCorners, AnInsetStaysInItsCornerForAllOfItsCutAndFollowsTheWorkOfThatCutAlone) {
  Recording recording;
  recording.show_inset(0.5);
  recording.show_inset(3);
  recording.work = {press(kUpperRight)};
  const ClearCorners corners = recording.corners();
  for (const double time : {0.5, 1.0, 1.5, 2.0, 2.9}) EXPECT_EQ(corners.inset(time), PictureCorner::kUpperLeft) << time;
  EXPECT_EQ(corners.inset(3), PictureCorner::kUpperRight) << "the press is over";
  EXPECT_FALSE(corners.inset(0.4)) << "before the first cut there is none";
}

TEST(ClearCorners, WhatIsPointedAtIsKeptClearWhileItIsShown) {
  Recording recording;
  recording.show_inset(0);
  recording.show_inset(2);
  recording.annotations.labels = {
      {.text = "Here", .body = "wall", .at = kUpperRight, .span = {.begin = 0, .end = 1.5}}};
  EXPECT_EQ(recording.corners().inset(0), PictureCorner::kUpperLeft);
  EXPECT_EQ(recording.corners().inset(2), PictureCorner::kUpperRight);
  recording.annotations = {};
  recording.annotations.arrows = {{.body = "wall", .at = kUpperRight}};
  EXPECT_EQ(recording.corners().inset(2), PictureCorner::kUpperLeft);
  recording.annotations = {};
  recording.view.highlights = {{.body = "wall", .center = kUpperRight}};
  EXPECT_EQ(recording.corners().inset(2), PictureCorner::kUpperLeft);
}

TEST(ClearCorners, ACornerThatTheScenarioNamesIsLeftToIt) {
  Recording recording;
  recording.show_inset(0);
  recording.view.cuts[0].corner = PictureCorner::kUpperRight;
  recording.work = {press(kUpperRight)};
  EXPECT_FALSE(recording.corners().inset(1.5));
  recording.show_legend();
  recording.view.look.data->legend = PictureCorner::kLowerRight;
  EXPECT_EQ(recording.corners().legend(), PictureCorner::kLowerRight);
}

TEST(ClearCorners, OfAToolThatTheCameraFollowsTheWorkIsInTheMiddle) {
  Recording recording;
  recording.show_inset(0);
  recording.view.camera.follow = CameraFollow{.tool = "probe"};
  recording.work = {press(kUpperRight)};
  EXPECT_EQ(recording.corners().inset(1.5), PictureCorner::kUpperRight);
}

TEST(ClearCorners, TheRightHalfIsKeptClearToo) {
  Recording recording;
  recording.view.cuts = {{.time = 0, .beside = "other", .inset = "other"}};
  // A half is as high as the picture and half as wide: its left border is at x = -0.047.
  recording.work = {press({-0.04, 0.03, 0})};
  EXPECT_EQ(recording.corners().inset(1.5), PictureCorner::kUpperRight) << "left in both halves";
  recording.work = {press({0.04, 0.03, 0})};
  EXPECT_EQ(recording.corners().inset(1.5), PictureCorner::kUpperLeft) << "right in both halves";
}

TEST(ClearCorners, ALegendStandsWhereItCoversNoWorkOfAnyCut) {
  Recording recording;
  recording.show_legend();
  recording.work = {press(kMiddle)};
  EXPECT_EQ(recording.corners().legend(), PictureCorner::kUpperRight);
  recording.work = {press({0.09, 0.03, 0})};
  EXPECT_EQ(recording.corners().legend(), PictureCorner::kUpperLeft);
}

TEST(ClearCorners, ALegendGivesWayToNoInsetOfSomeCutsAlone) {
  Recording recording;
  recording.show_legend();
  recording.work = {press(kMiddle)};
  recording.show_inset(2);
  EXPECT_EQ(recording.corners().inset(2), PictureCorner::kUpperRight);
  EXPECT_EQ(recording.corners().legend(), PictureCorner::kUpperLeft) << "it would jump from there as the inset comes";
  recording.view.cuts[0].time = 0;
  EXPECT_EQ(recording.corners().legend(), PictureCorner::kUpperRight) << "the inset is there all the time";
}

TEST(ClearCorners, BesideACaptionOfAHalfNoLegendStands) {
  Recording recording;
  recording.show_legend();
  auto comparison = std::make_shared<TakeComparison>();
  comparison->second = recording.view;
  recording.view.comparison = comparison;
  recording.view.look.data->legend = PictureCorner::kUpperLeft;
  EXPECT_EQ(recording.corners().legend(), PictureCorner::kLowerLeft);
}

}  // namespace
}  // namespace thinwall
