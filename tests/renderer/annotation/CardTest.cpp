#include "renderer/annotation/Card.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/renderer/annotation/AnnotatedScenes.hpp"

namespace thinwall {
namespace {

TEST(Card, DarkensThePictureAndFades) {
  Image bright{.size = kSize, .pixels = std::vector<std::uint8_t>(3UL * kSize.width * kSize.height, 200)};
  Image full = bright;
  draw_card(full, bright, {.title = "Title", .text = "and more"});
  // 84 % of a nearly black layer; its opacity, its colour and the sum are rounded to whole levels.
  EXPECT_NEAR(level(full, 10, 10), 0.16 * 200 + 0.84 * 0.02 * 255, 2);
  Image gone = bright;
  draw_card(gone, bright, {.title = "Title", .opacity = 0});
  EXPECT_EQ(gone.pixels, bright.pixels);
}

TEST(Card, TakesThePlaceOfWhatWasWrittenOnThePictureBefore) {
  const Image bare{.size = kSize, .pixels = std::vector<std::uint8_t>(3UL * kSize.width * kSize.height, 100)};
  Image written = bare;
  std::fill_n(written.pixels.begin(), 3 * 2 * kSize.width, std::uint8_t{220});
  for (const double opacity : {0.5, 1.0}) {
    Image over = written, empty = bare;
    draw_card(over, bare, {.title = "Title", .opacity = opacity});
    draw_card(empty, bare, {.title = "Title", .opacity = opacity});
    // Of the difference of 120 levels as much is left as the card lets through, and of that what has not gone.
    EXPECT_NEAR(level(over, 10, 1) - level(empty, 10, 1), 120 * (1 - opacity) * (1 - 0.84 * opacity), 2) << opacity;
    EXPECT_EQ(level(over, 10, 10), level(empty, 10, 10));
  }
}

}  // namespace
}  // namespace thinwall
