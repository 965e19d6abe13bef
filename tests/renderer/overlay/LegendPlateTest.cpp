#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "renderer/overlay/HalfCaptions.hpp"
#include "renderer/overlay/Plate.hpp"
#include "tests/renderer/overlay/OverlayContents.hpp"

namespace thinwall {
namespace {

TEST(LegendPlate, OfARootScaleHasTheSameColorsAndItsNumbersElsewhere) {
  OverlayContent content = nothing();
  content.legend = Legend{.title = "Von Mises stress", .unit = "Pa", .from = 0, .to = 20e3};
  const Image linear = overlaid(content);
  content.legend->scale = DataScale::kRoot;
  const Image root = overlaid(content);
  int first = kSize.width;
  for (std::size_t i = 0; i < root.pixels.size(); ++i) {
    if (linear.pixels[i] != root.pixels[i]) first = std::min(first, static_cast<int>(i / 3 % kSize.width));
  }
  // Margin and width of the plate, its padding and the bar lie before the marks.
  EXPECT_NEAR(first, kSize.width - 26 - 150 + 15 + 22, 1);
}

TEST(LegendPlate, TellsOfAnEndThatStandsForMore) {
  OverlayContent content = nothing();
  content.legend = Legend{.title = "Von Mises stress", .unit = "Pa", .from = 0, .to = 20e3};
  const Image exact = overlaid(content);
  content.legend->goes_on_above = true;
  const Image open = overlaid(content);
  int first = kSize.height, last = -1;
  for (int row = 0; row < kSize.height; ++row) {
    const auto begin = static_cast<std::ptrdiff_t>(row) * kSize.width * 3, end = begin + kSize.width * 3;
    if (std::equal(exact.pixels.begin() + begin, exact.pixels.begin() + end, open.pixels.begin() + begin)) continue;
    first = std::min(first, row);
    last = row;
  }
  // The number at the upper end of the colours alone.
  EXPECT_GT(first, 120);
  EXPECT_LT(last, 170);
  EXPECT_LE(first, last);
}

TEST(LegendPlate, StandsAtTheRightOrWhereAnInsetLeavesTheMiddleFree) {
  OverlayContent content = some_content();
  content.legend = Legend{.title = "Stress", .unit = "Pa", .from = 0, .to = 1000};
  const auto place = [&](const std::optional<Box>& inset) { return places_of_legends(content, kSize, inset).at(0); };
  const Box usual = place({});
  EXPECT_EQ(usual.right(), 1280 - 26);
  const Box at_the_left{26, 78, 384, 216};
  EXPECT_EQ(place(at_the_left).x, usual.x);
  for (const Box& inset : {Box{870, 78, 384, 216}, Box{870, 294, 384, 216}}) {
    const Box moved = place(inset);
    EXPECT_EQ(moved.x, 26) << inset.y;
    EXPECT_EQ(moved.y, usual.y) << inset.y;
  }
  const Box small{1062, 78, 192, 108};
  EXPECT_EQ(place(small).x, usual.x);
  EXPECT_GE(place(small).y, small.bottom());
  EXPECT_LE(place(small).bottom(), 522) << "above the panels";
}

TEST(LegendPlate, StandsInTheCornerThatItIsGivenClearOfTitleAndPanels) {
  for (const ImageSize size : {kSize, ImageSize{720, 720}, ImageSize{540, 960}}) {
    OverlayContent content = some_content();
    content.legend = Legend{.title = "Stress", .unit = "Pa", .from = 0, .to = 1000};
    const auto place = [&](PictureCorner corner) {
      content.legend->corner = corner;
      return places_of_legends(content, size, {}).at(0);
    };
    const Box usual = place(PictureCorner::kUpperRight), opposite = place(PictureCorner::kLowerLeft);
    EXPECT_NEAR(opposite.x, size.width - usual.right(), 1e-9) << size.width;
    EXPECT_EQ(place(PictureCorner::kUpperLeft).x, opposite.x);
    EXPECT_EQ(place(PictureCorner::kUpperLeft).y, usual.y);
    EXPECT_EQ(place(PictureCorner::kLowerRight).x, usual.x);
    EXPECT_EQ(place(PictureCorner::kLowerRight).y, opposite.y);
    EXPECT_GT(opposite.y, usual.y);
    // What draws panels and captions leaves it as it is.
    const Image with = overlaid(content, size);
    content.shown.gauge = content.shown.force_plot = content.shown.captions = false;
    const Image without = overlaid(content, size);
    const auto row_of = [&](const Image& image, int y) {
      return image.pixels.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * size.width);
    };
    const auto left = 3 * static_cast<std::ptrdiff_t>(usual.x), right = 3 * static_cast<std::ptrdiff_t>(usual.right());
    for (int y = static_cast<int>(opposite.y); y < opposite.bottom(); ++y) {
      EXPECT_TRUE(std::equal(row_of(with, y) + left, row_of(with, y) + right, row_of(without, y) + left)) << y;
    }
  }
}

TEST(LegendPlate, StandsAboveAnInsetInALowerCornerOrBesideIt) {
  OverlayContent content = some_content();
  content.legend = Legend{.title = "Stress", .unit = "Pa", .corner = PictureCorner::kLowerRight};
  const Box usual = places_of_legends(content, kSize, {}).at(0);
  const Box beside = places_of_legends(content, kSize, Box{870, 294, 384, 216}).at(0);
  EXPECT_EQ(beside.x, 26);
  EXPECT_EQ(beside.y, usual.y);
  const Box small{1062, 402, 192, 108};
  const Box above = places_of_legends(content, kSize, small).at(0);
  EXPECT_EQ(above.x, usual.x);
  EXPECT_LE(above.bottom(), small.y);
}

TEST(LegendPlate, OfTheLeftOfTwoTakesStandsInItsHalf) {
  OverlayContent content;
  const Image bare = overlaid(content);
  content.left_legend = Legend{.title = "Stress", .unit = "Pa", .from = 0, .to = 1000};
  const Image image = overlaid(content);
  const std::vector<Box> places = places_of_legends(content, kSize, {});
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].right(), 640 - 26);
  int changed_within = 0, changed_beside = 0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const auto first = 3 * (static_cast<std::ptrdiff_t>(y) * kSize.width + x);
      const bool is_changed =
          !std::equal(image.pixels.begin() + first, image.pixels.begin() + first + 3, bare.pixels.begin() + first);
      const bool is_within = x >= places[0].x && x < places[0].right() && y >= places[0].y && y < places[0].bottom();
      (is_within ? changed_within : changed_beside) += is_changed ? 1 : 0;
    }
  }
  EXPECT_GT(changed_within, 0.9 * places[0].width * places[0].height);
  EXPECT_EQ(changed_beside, 0);
}

TEST(LegendPlate, OfTheRightOfTwoTakesStandsInItsHalfInEveryCorner) {
  OverlayContent content;
  for (const PictureCorner corner :
       {PictureCorner::kUpperLeft, PictureCorner::kUpperRight, PictureCorner::kLowerLeft, PictureCorner::kLowerRight}) {
    content.legend = Legend{.title = "Stress", .unit = "Pa", .corner = corner};
    content.legend_is_of_the_right = false;
    const Box of_both = places_of_legends(content, kSize, {}).at(0);
    content.legend_is_of_the_right = true;
    const Box place = places_of_legends(content, kSize, {}).at(0);
    EXPECT_EQ(place.x, is_left(corner) ? 640 + 26 : of_both.x);
    EXPECT_EQ(place.y, of_both.y);
  }
}

TEST(LegendPlate, StandsBelowTheCaptionOfItsHalfWhereThatNeedsTheRoom) {
  OverlayContent content;
  content.legend = Legend{.title = "Stress", .unit = "Pa"};
  for (const ImageSize size : {kSize, ImageSize{720, 1280}, ImageSize{270, 480}}) {
    content.half_captions = {};
    const Box usual = places_of_legends(content, size, {}).at(0);
    content.half_captions = {"Soft wall: 20 kPa", "Stiff wall: 80 kPa, as after a scar"};
    const Box place = places_of_legends(content, size, {}).at(0);
    for (const Box& caption : half_caption_places(size, content.half_captions)) {
      EXPECT_FALSE(place.overlaps(caption)) << size.width;
    }
    EXPECT_EQ(place.x, usual.x);
    EXPECT_TRUE(size.height > size.width || place.y == usual.y) << size.width << ": there is room beside it";
    EXPECT_LT(place.bottom(), size.height - height_of_panels_and_captions(OverlayGrid(size))) << size.width;
  }
}

}  // namespace
}  // namespace thinwall
