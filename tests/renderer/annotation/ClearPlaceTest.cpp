#include "renderer/annotation/ClearPlace.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

constexpr Box kBounds{0, 0, 600, 400};
constexpr double kGap = 6;
constexpr Box kText{300, 200, 80, 30};

TEST(ClearPlace, ATextThatIsClearStaysWhereItIs) {
  const Box place = clear_place(kText, {Box{386, 200, 80, 30}, Box{300, 236, 80, 30}}, kGap, kBounds);
  EXPECT_EQ(place.x, 300);
  EXPECT_EQ(place.y, 200);
}

TEST(ClearPlace, ATextGoesAboveOrBelowAPlateWhicheverIsNearer) {
  const Box below = clear_place(kText, {Box{310, 190, 80, 30}}, kGap, kBounds);
  EXPECT_EQ(below.x, 300);
  EXPECT_EQ(below.y, 226);
  const Box above = clear_place(kText, {Box{310, 212, 80, 30}}, kGap, kBounds);
  EXPECT_EQ(above.x, 300);
  EXPECT_EQ(above.y, 176);
}

TEST(ClearPlace, ATextGoesALittleAcrossRatherThanFarUpOrDown) {
  const Box legend{370, 60, 150, 300};
  const Box place = clear_place(kText, {legend}, kGap, kBounds);
  EXPECT_EQ(place.x, legend.x - kGap - kText.width);
  EXPECT_EQ(place.y, 200);
}

TEST(ClearPlace, ATextBetweenAPlateAndAnInsetGoesBothWays) {
  const Box inset{370, 40, 200, 300}, plate{250, 196, 100, 30};
  const Box place = clear_place(kText, {inset, plate}, kGap, kBounds);
  EXPECT_EQ(place.x, inset.x - kGap - kText.width);
  EXPECT_EQ(place.y, plate.bottom() + kGap);
}

TEST(ClearPlace, ATextStaysInsideTheBoundsWhereThereIsRoom) {
  const Box text{300, 4, 80, 30};
  const Box place = clear_place(text, {Box{300, 10, 80, 30}}, kGap, kBounds);
  EXPECT_EQ(place.y, 46) << "there is no room above";
}

}  // namespace
}  // namespace thinwall
