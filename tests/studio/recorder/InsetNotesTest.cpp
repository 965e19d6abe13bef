#include "studio/recorder/InsetNotes.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

constexpr ImageSize kInsetSize{640, 360};

/// A tool that touches a wall at `tip`, seen from above.
Snapshot touching(Double3 tip, double time) {
  auto topology = std::make_shared<SnapshotTopology>();
  topology->rest_positions = {{-0.05F, -0.05F, 0}, {0.05F, -0.05F, 0}, {0.05F, 0.05F, 0}};
  topology->triangles = {{0, 1, 2}};
  Snapshot snapshot;
  snapshot.time = time;
  snapshot.surfaces = {{.body = "wall", .topology = topology, .positions = topology->rest_positions, .fields = {}}};
  SnapshotTool probe;
  probe.name = "probe";
  probe.tip = tip;
  probe.force = {0, 0, 1};
  snapshot.tools = {probe};
  return snapshot;
}

Shot with_inset(PictureCorner corner) {
  Shot shot;
  shot.camera = {.position = Double3{0, 0, 0.2}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}};
  shot.inset = shot.camera;
  shot.corner = corner;
  return shot;
}

TEST(InsetNotes, TellWhichToolIsCoveredAndWhichCornerIsFree) {
  InsetNotes notes;
  const Shot shot = with_inset(PictureCorner::kUpperRight);
  notes.see(touching({0, 0, 0}, 0.1), shot, kInsetSize);
  EXPECT_TRUE(notes.notes().empty()) << "in the middle of the picture";
  notes.see(touching({-0.07, 0.025, 0}, 0.2), shot, kInsetSize);
  EXPECT_TRUE(notes.notes().empty()) << "in another corner";
  notes.see(touching({0.07, 0.025, 0}, 0.3), shot, kInsetSize);
  notes.see(touching({0.07, 0.025, 0}, 0.4), shot, kInsetSize);
  EXPECT_EQ(notes.notes(), std::vector<std::string>{
                               "cuts: the small picture (`inset`) covers the tip of tool `probe` while it touches, "
                               "first at 0.3 s; `corner: lower_left` leaves it free"});
}

TEST(InsetNotes, ToolsThatDoNotTouchAndPicturesWithoutInsetAreFine) {
  InsetNotes notes;
  Snapshot snapshot = touching({0.07, 0.025, 0}, 0.3);
  Shot shot = with_inset(PictureCorner::kUpperRight);
  shot.inset.reset();
  notes.see(snapshot, shot, kInsetSize);
  snapshot.tools[0].force = {0, 0, 0};
  notes.see(snapshot, with_inset(PictureCorner::kUpperRight), kInsetSize);
  EXPECT_TRUE(notes.notes().empty());
}

}  // namespace
}  // namespace thinwall
