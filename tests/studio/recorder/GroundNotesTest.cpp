#include "studio/recorder/GroundNotes.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

bool tells(const ViewDefinition& view, const Double3& gravity, const Shot& shot = {}) {
  GroundNotes ground(view);
  Snapshot snapshot;
  snapshot.gravity = gravity;
  ground.see(snapshot, shot);
  ground.see(Snapshot{}, shot);
  return !ground.notes().empty();
}

TEST(GroundNotes, TellWhereGravityPullsAlongTheGround) {
  EXPECT_TRUE(tells({}, {0, -9.81, 0}));
  EXPECT_FALSE(tells({}, {0, 0, -9.81}));
  EXPECT_FALSE(tells({}, {0, 0, 0}));
}

TEST(GroundNotes, TellNothingOfPicturesThatHaveNoGround) {
  ViewDefinition bare;
  bare.look.floor = false;
  EXPECT_FALSE(tells(bare, {0, -9.81, 0}));
  ViewDefinition lit_by_lamp;
  lit_by_lamp.lights.endoscope = 1;
  EXPECT_FALSE(tells(lit_by_lamp, {0, -9.81, 0}));
  Shot shot;
  shot.camera.lamp = 1;
  EXPECT_FALSE(tells({}, {0, -9.81, 0}, shot));
}

}  // namespace
}  // namespace thinwall
