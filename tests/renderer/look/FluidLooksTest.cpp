#include "renderer/look/FluidLooks.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

TEST(FluidLooks, BareFleshIsOfTheWallsLayersWhereItDoesNotBleed) {
  TissueLook look;
  look.bleeding = 0;
  const FluidLook bare = bare_flesh(look);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_DOUBLE_EQ(bare.color[c], 0.5 * (look.layers.outer[c] + look.layers.middle[c])) << c;
  }
}

TEST(FluidLooks, BareFleshIsTheRedderTheMoreItBleeds) {
  double before = 1;
  for (const double bleeding : {0.0, 0.1, 0.4, 1.0}) {
    TissueLook look;
    look.bleeding = bleeding;
    const Double3 color = bare_flesh(look).color;
    const double paleness = color[1] / color[0];
    EXPECT_LT(paleness, before) << bleeding;
    before = paleness;
  }
  // A tint that is seen on the outer layer, not blood itself.
  const WallLayers layers;
  EXPECT_LT(before, 0.65 * layers.outer[1] / layers.outer[0]);
  EXPECT_GT(before, 2 * kFreshBlood.color[1] / kFreshBlood.color[0]);
}

}  // namespace
}  // namespace thinwall
