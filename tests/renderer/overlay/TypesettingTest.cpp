#include "renderer/overlay/Typesetting.hpp"

#include <gtest/gtest.h>

#include "renderer/overlay/Font.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {
namespace {

TEST(Typesetting, RaisesPowersOfUnits) {
  EXPECT_EQ(typeset("20 J/m^2"), "20\u00a0J/\u2060m\u00b2");
  EXPECT_EQ(typeset("1060 kg/m^3 here"), "1060\u00a0kg/\u2060m\u00b3 here");
  EXPECT_EQ(typeset("10^2 or x^24"), "10^2 or x^24");
}

TEST(Typesetting, KeepsANumberWithItsUnit) {
  EXPECT_EQ(typeset("Pressed 6 mm deep"), "Pressed 6\u00a0mm deep");
  EXPECT_EQ(typeset("by 30 %"), "by 30\u00a0%");
  EXPECT_EQ(typeset("4 steps, 2 mmm, 3 m2"), "4 steps, 2 mmm, 3 m2");
  EXPECT_EQ(typeset("and/or: Lèvre 2"), "and/or: Lèvre 2");
  EXPECT_EQ(typeset(""), "");
}

TEST(Typesetting, LinesEndBeforeANumberNotWithinItsUnit) {
  const FontUse use;
  const Text text("Healthy capsule, toughness 0.05 kJ/m^2", {.size = 19}, {.width = 200, .lines = 3});
  EXPECT_EQ(text.lines(), 2);
  EXPECT_FALSE(text.has_broken_word());
  EXPECT_EQ(text.unknown_letters(), 0);
}

}  // namespace
}  // namespace thinwall
