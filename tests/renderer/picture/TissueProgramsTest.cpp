#include "renderer/picture/TissuePrograms.hpp"

#include <gtest/gtest.h>

#include "renderer/look/OrganLooks.hpp"

namespace thinwall {
namespace {

bool says(const std::string& defines, const char* line) {
  return defines.find(std::string("#define ") + line + '\n') != std::string::npos;
}

LookUniforms look_of(const char* organ, TissueSide side = TissueSide::kOutside) {
  return look_uniforms(*find_organ_look(organ), side);
}

TEST(TissuePrograms, APartDoesWhatItsLookHas) {
  const std::string fingerpad = tissue_defines(look_of("fingerpad"), {});
  EXPECT_TRUE(says(fingerpad, "RIDGED true"));
  EXPECT_TRUE(says(fingerpad, "CREASED true"));
  EXPECT_TRUE(says(fingerpad, "FATTY false"));
  const std::string gallbladder = tissue_defines(look_of("gallbladder"), {});
  EXPECT_TRUE(says(gallbladder, "FATTY true"));
  EXPECT_TRUE(says(gallbladder, "CLEAR true"));
  EXPECT_TRUE(says(gallbladder, "VESSELED true"));
  EXPECT_TRUE(says(fingerpad, "VESSELED false"));
  EXPECT_TRUE(says(tissue_defines(look_of("gallbladder", TissueSide::kLining), {}), "VESSELED false"));
  EXPECT_TRUE(says(gallbladder, "RIDGED false"));
}

TEST(TissuePrograms, OnlyALiningLiesInFolds) {
  EXPECT_TRUE(says(tissue_defines(look_of("stomach", TissueSide::kLining), {}), "FOLDED true"));
  EXPECT_TRUE(says(tissue_defines(look_of("stomach"), {}), "FOLDED false"));
  EXPECT_TRUE(says(tissue_defines(look_of("gallbladder", TissueSide::kLining), {}), "FOLDED false"));
}

TEST(TissuePrograms, OnlyACutShowsLayers) {
  EXPECT_TRUE(says(tissue_defines(look_of("stomach", TissueSide::kRim), {}), "LAYERED true"));
  EXPECT_TRUE(says(tissue_defines(look_of("stomach", TissueSide::kLining), {}), "LAYERED false"));
}

TEST(TissuePrograms, WallsOfWoundsAndOpenedOrgansAreEnclosed) {
  for (const TissueSide side : {TissueSide::kRim, TissueSide::kLining, TissueSide::kBed}) {
    EXPECT_TRUE(says(tissue_defines(look_of("skin", side), {}), "ENCLOSED true"));
  }
  for (const TissueSide side : {TissueSide::kOutside, TissueSide::kCap}) {
    EXPECT_TRUE(says(tissue_defines(look_of("skin", side), {}), "ENCLOSED false"));
  }
}

TEST(TissuePrograms, SkinHasPoresOnItsOutsideAndNothingFinerThanItsLines) {
  const std::string skin = tissue_defines(look_of("skin"), {});
  EXPECT_TRUE(says(skin, "PORED true"));
  EXPECT_TRUE(says(skin, "DUSTED false"));
  EXPECT_TRUE(says(tissue_defines(look_of("liver"), {}), "PORED false"));
  for (const TissueSide side : {TissueSide::kRim, TissueSide::kLining, TissueSide::kBed}) {
    EXPECT_TRUE(says(tissue_defines(look_of("skin", side), {}), "PORED false"));
  }
}

TEST(TissuePrograms, ShadowsAreSoftWithinWoundsBelowLargeLamps) {
  const TissueScene cavity{.surroundings = Surroundings::kCavity};
  EXPECT_TRUE(says(tissue_defines(look_of("skin", TissueSide::kBed), {}), "SOFT_SHADOW true"));
  EXPECT_FALSE(says(tissue_defines(look_of("skin", TissueSide::kBed), cavity), "SOFT_SHADOW true"));
  EXPECT_FALSE(says(tissue_defines(look_of("skin"), {}), "SOFT_SHADOW true"));
}

TEST(TissuePrograms, WhatIsTooFineForThePixelsIsLeftOut) {
  const LookUniforms look = look_of("fingerpad");
  const float size = 1 / look.relief[1];
  EXPECT_TRUE(says(tissue_defines(look, {.smallest_footprint = 0.27F * size}), "DUSTED true"));
  EXPECT_TRUE(says(tissue_defines(look, {.smallest_footprint = 0.28F * size}), "DUSTED false"));
}

TEST(TissuePrograms, WhereNoShadowIsCastNoneIsLookedUp) {
  EXPECT_TRUE(says(tissue_defines({}, {.is_shadowed = false}), "SHADOWED false"));
  EXPECT_TRUE(says(tissue_defines({}, {.is_shadowed = true}), "SHADOWED true"));
}

TEST(TissuePrograms, WhereNoToolsAreTheirShadowIsNotLookedUp) {
  EXPECT_TRUE(says(tissue_defines({}, {.is_shadowed = true, .rods = 1}), "TOOLS_SHADE true"));
  EXPECT_FALSE(says(tissue_defines({}, {.is_shadowed = true, .rods = 0}), "TOOLS_SHADE true"));
  EXPECT_FALSE(says(tissue_defines({}, {.is_shadowed = false, .rods = 1}), "TOOLS_SHADE true"));
}

TEST(TissuePrograms, NoMoreRodsCountThanTheFrameTells) {
  EXPECT_TRUE(says(tissue_defines({}, {.rods = 2}), "ROD_COUNT 2"));
  EXPECT_TRUE(says(tissue_defines({}, {.rods = 9}), "ROD_COUNT 3"));
}

}  // namespace
}  // namespace thinwall
