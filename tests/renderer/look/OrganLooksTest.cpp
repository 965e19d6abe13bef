#include "renderer/look/OrganLooks.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

TEST(OrganLooks, AreFoundByTheirNames) {
  EXPECT_EQ(organ_looks().front().organ, "tissue");
  for (const OrganLook& organ : organ_looks()) EXPECT_EQ(find_organ_look(organ.organ), &organ.look);
  EXPECT_EQ(find_organ_look("heart"), nullptr);
}

TEST(OrganLooks, HaveNamesThatAreNotPartOfEachOther) {
  // A body's look is told by the first of these names that is part of its own.
  for (const OrganLook& a : organ_looks()) {
    for (const OrganLook& b : organ_looks()) {
      if (&a == &b) continue;
      EXPECT_EQ(a.organ.find(b.organ), std::string_view::npos) << a.organ << " holds " << b.organ;
    }
  }
}

TEST(OrganLooks, DoNotReflectMoreThanTheyGet) {
  for (const OrganLook& organ : organ_looks()) {
    const TissueLook& look = organ.look;
    for (const Double3& color :
         {look.color, look.blood, look.fat, look.through, look.layers.outer, look.layers.middle, look.layers.inner}) {
      for (const double channel : color) {
        EXPECT_GE(channel, 0) << organ.organ;
        EXPECT_LE(channel, 1) << organ.organ;
      }
    }
    for (const double part : {look.roughness, look.wetness, look.mottling, look.clearness, look.sheen}) {
      EXPECT_GE(part, 0) << organ.organ;
      EXPECT_LE(part, 1) << organ.organ;
    }
    EXPECT_LT(look.layers.outer_part + look.layers.inner_part, 1) << organ.organ;
    // Divided by.
    for (const double size : {look.vessel_spacing, look.relief_size, look.patch_size})
      EXPECT_GT(size, 0) << organ.organ;
  }
}

}  // namespace
}  // namespace thinwall
