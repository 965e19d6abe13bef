#include "renderer/overlay/HalfCaptions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace thinwall {
namespace {

constexpr ImageSize kHalvesSize{1280, 720};

Image captioned(const std::string& left, const std::string& right, const std::optional<Box>& inset = {},
                ImageSize size = kHalvesSize) {
  Image image{.size = size, .pixels = std::vector<std::uint8_t>(3UL * size.width * size.height, 128)};
  draw_half_captions(image, {left, right}, inset);
  return image;
}

bool is_changed(const Image& image, int x, int y) {
  return image.pixels[3 * (static_cast<std::size_t>(y) * kHalvesSize.width + static_cast<std::size_t>(x))] != 128;
}

/// The first column right of `from` and before `to` from which on nothing is drawn.
int right_end(const Image& image, int from, int to) {
  int end = from;
  for (int x = from; x < to; ++x) {
    for (int y = 0; y < kHalvesSize.height; ++y) {
      if (is_changed(image, x, y)) end = x + 1;
    }
  }
  return end;
}

TEST(HalfCaptions, StandInThePlacesThatAreToldOfThem) {
  const std::array<std::string, 2> captions{"Wall 2 mm thick", "A wall that has been inflamed for weeks"};
  const std::vector<Box> places = half_caption_places(kHalvesSize, captions);
  ASSERT_EQ(places.size(), 2U);
  const Image image = captioned(captions[0], captions[1]);
  for (const Box& place : places) {
    EXPECT_TRUE(is_changed(image, static_cast<int>(place.x + 20), static_cast<int>(place.y + 20)));
    EXPECT_EQ(right_end(image, place.x < 640 ? 0 : 650, place.x < 640 ? 630 : 1280), static_cast<int>(place.right()));
  }
  const Box inset{700, 60, 300, 100};
  EXPECT_GE(half_caption_places(kHalvesSize, captions, inset)[1].y, inset.bottom()) << "below what has its place";
  EXPECT_TRUE(half_caption_places(kHalvesSize, {"", ""}).empty());
}

TEST(HalfCaptions, LeaveTheMiddleOfTheHalvesFree) {
  for (const char* caption :
       {"Wall 2 mm thick", "A wall that has been inflamed for weeks and is three times as thick"}) {
    const Image image = captioned(caption, caption);
    EXPECT_LT(right_end(image, 0, 630), 280) << caption;
    EXPECT_LT(right_end(image, 650, 1280), 640 + 280) << caption;
    EXPECT_TRUE(is_changed(image, 60, 99)) << caption;
    EXPECT_TRUE(is_changed(image, 700, 99)) << caption;
  }
}

TEST(HalfCaptions, StandAlikeInBothHalves) {
  const Image image = captioned("Thin", "Thin");
  for (int y = 60; y < 140; ++y) {
    // The line between the halves is two pixels wide.
    for (int x = 4; x < 280; ++x) EXPECT_EQ(is_changed(image, x, y), is_changed(image, x + 640, y)) << x << ' ' << y;
  }
}

TEST(HalfCaptions, StandBelowAnInsetThatHasTheirPlace) {
  for (const Box& inset : {Box{26, 78, 384, 216}, Box{870, 78, 384, 216}}) {
    const Image image = captioned("Thin", "Thick", inset);
    for (int y = 78; y < 294; ++y) {
      for (int x = static_cast<int>(inset.x); x < inset.right(); ++x) ASSERT_FALSE(is_changed(image, x, y));
    }
    // An inset at the left moves the left caption; one at the right leaves both, which stand left of it.
    EXPECT_EQ(is_changed(image, 60, 313), inset.x < 640);
    EXPECT_TRUE(is_changed(image, 700, 99));
  }
}

TEST(HalfCaptions, AreWholeInPicturesOfEveryShape) {
  const auto pixels = [](const char* last, ImageSize size) {
    return captioned("The wall of a patient who is old, 3 mm " + std::string(last), "", {}, size).pixels;
  };
  for (const ImageSize size : {ImageSize{1280, 720}, ImageSize{1024, 768}, ImageSize{720, 720}, ImageSize{720, 1280}}) {
    EXPECT_TRUE(pixels("thick", size) != pixels("thin", size)) << size.width << " x " << size.height;
  }
}

}  // namespace
}  // namespace thinwall
