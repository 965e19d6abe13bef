#include "studio/recorder/HiddenToolNotes.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{640, 360};

/// An upright square wall, 100 mm wide, that a ball dents by 5 mm from the side of larger y.
Snapshot dented_wall(double time) {
  auto topology = std::make_shared<SnapshotTopology>();
  topology->rest_positions = {{-0.05F, 0, -0.05F}, {0.05F, 0, -0.05F}, {0.05F, 0, 0.05F}, {-0.05F, 0, 0.05F}};
  topology->triangles = {{0, 1, 2}, {0, 2, 3}};
  Snapshot snapshot;
  snapshot.time = time;
  snapshot.surfaces = {{.body = "wall", .topology = topology, .positions = topology->rest_positions, .fields = {}}};
  SnapshotTool probe;
  probe.name = "probe";
  probe.kind = SnapshotToolKind::kSphere;
  probe.radius = 0.004;
  probe.tip = {0, -0.005, 0};
  probe.direction = {0, -1, 0};
  probe.depth = 0.005;
  probe.force = {0, 1, 0};
  snapshot.tools = {probe};
  return snapshot;
}

Shot from(double y) {
  Shot shot;
  shot.camera = {.position = Double3{0, y, 0.05}, .target = Double3{0, 0, 0}};
  return shot;
}

TEST(HiddenToolNotes, TellWhichToolIsNeverSeenTouchingAndASideThatShowsIt) {
  HiddenToolNotes notes;
  notes.see(dented_wall(0.1), from(-0.3), kSize);
  notes.see(dented_wall(0.2), from(-0.3), kSize);
  EXPECT_EQ(notes.notes(),
            std::vector<std::string>{
                "camera: a wall hides where tool `probe` touches in all pictures of that, from 0.1 s on; "
                "without `position` and with `facing: [-0.60, -0.60, -0.54]` it shows it"});
}

TEST(HiddenToolNotes, AToolThatIsSeenOnceOrDoesNotTouchIsFine) {
  HiddenToolNotes notes;
  notes.see(dented_wall(0.1), from(-0.3), kSize);
  notes.see(dented_wall(0.2), from(0.3), kSize);
  EXPECT_TRUE(notes.notes().empty());
  Snapshot away = dented_wall(0.1);
  away.tools[0].force = {0, 0, 0};
  HiddenToolNotes others;
  others.see(away, from(-0.3), kSize);
  EXPECT_TRUE(others.notes().empty());
}

TEST(HiddenToolNotes, TellWhichToolTouchesBesideAllPicturesAndWhere) {
  Shot beside = from(0.3);
  beside.camera.target = Double3{0.2, 0, 0};
  HiddenToolNotes notes, seen_once, pinhole, endoscope;
  for (const double time : {0.1, 0.2}) notes.see(dented_wall(time), beside, kSize);
  EXPECT_EQ(notes.notes(),
            std::vector<std::string>{
                "camera: where tool `probe` touches lies beside the picture in all pictures of that, from 0.1 s on; "
                "`target: [0 mm, -5 mm, 0 mm]` brings it into the middle"});
  seen_once.see(dented_wall(0.1), beside, kSize);
  seen_once.see(dented_wall(0.2), from(0.3), kSize);
  EXPECT_TRUE(seen_once.notes().empty());
  // Off the line of sight by a tangent of 0.37: within half the picture's width, 0.48, and beyond the round one, 0.30.
  beside.camera.target = Double3{0.115, 0, 0};
  pinhole.see(dented_wall(0.1), beside, kSize);
  EXPECT_TRUE(pinhole.notes().empty());
  beside.camera.kind = CameraKind::kEndoscope;
  endoscope.see(dented_wall(0.1), beside, kSize);
  EXPECT_EQ(endoscope.notes().size(), 1U);
}

TEST(HiddenToolNotes, ASecondPictureMayShowWhatTheFirstDoesNot) {
  HiddenToolNotes notes;
  Shot shot = from(-0.3);
  shot.inset = from(0.3).camera;
  notes.see(dented_wall(0.1), shot, kSize);
  EXPECT_TRUE(notes.notes().empty());
}

TEST(HiddenToolNotes, FromWithinABodyTheDentIsSeen) {
  Snapshot ball = dented_wall(0.1);
  ball.surfaces[0] = test::sphere("wall", {0, -0.05, 0.02}, 0.05, 3);
  HiddenToolNotes within, outside;
  within.see(ball, from(-0.06), kSize);
  outside.see(ball, from(-0.3), kSize);
  EXPECT_TRUE(within.notes().empty());
  EXPECT_EQ(outside.notes().size(), 1U);
}

}  // namespace
}  // namespace thinwall
