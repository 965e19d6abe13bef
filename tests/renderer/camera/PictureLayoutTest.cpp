#include "renderer/camera/PictureLayout.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

Image flat(ImageSize size, std::uint8_t level) {
  return {.size = size,
          .pixels = std::vector<std::uint8_t>(static_cast<std::size_t>(3 * size.width * size.height), level)};
}

std::uint8_t at(const Image& image, int x, int y) {
  return image.pixels[static_cast<std::size_t>(3 * (y * image.size.width + x))];
}

TEST(PictureLayout, TwoHalvesFillThePictureWhateverItsWidth) {
  Shot shot;
  shot.beside = CameraDefinition{};
  for (const int width : {640, 641}) {
    const PictureBox left = main_box(shot, {width, 360});
    const PictureBox right = beside_box({width, 360});
    EXPECT_EQ(left.left, 0);
    EXPECT_EQ(right.left, left.size.width);
    EXPECT_EQ(left.size.width + right.size.width, width);
  }
  EXPECT_EQ(main_box({}, {640, 360}).size.width, 640);
}

TEST(PictureLayout, ASmallPictureLiesInItsCornerInsideTheLarge) {
  for (const ImageSize size : {ImageSize{1280, 720}, ImageSize{320, 180}, ImageSize{400, 400}}) {
    for (const PictureCorner corner : {PictureCorner::kUpperLeft, PictureCorner::kUpperRight, PictureCorner::kLowerLeft,
                                       PictureCorner::kLowerRight}) {
      const PictureBox box = inset_box({.corner = corner}, size);
      EXPECT_GE(box.left, 0);
      EXPECT_GE(box.top, 0);
      EXPECT_LE(box.left + box.size.width, size.width);
      EXPECT_LE(box.top + box.size.height, size.height);
      const bool is_left = corner == PictureCorner::kUpperLeft || corner == PictureCorner::kLowerLeft;
      EXPECT_EQ(2 * box.left + box.size.width < size.width, is_left);
    }
  }
}

TEST(PictureLayout, BesideAnotherPictureTheSmallOneIsOfTheHalvesScaleAndLeavesTheirMiddleFree) {
  const Shot shot{.beside = CameraDefinition{}, .corner = PictureCorner::kUpperRight};
  const ImageSize size{1280, 720};
  const PictureBox box = inset_box(shot, size);
  EXPECT_EQ(2 * box.size.width, inset_box({}, size).size.width);
  const PictureBox half = beside_box(size);
  EXPECT_GT(box.left, half.left + 0.6 * half.size.width);
}

TEST(PictureLayout, PastesPixelByPixelAndFramesInside) {
  Image image = flat({8, 6}, 10);
  const PictureBox box{.left = 2, .top = 1, .size = {4, 4}};
  paste(flat({4, 4}, 50), box, image);
  EXPECT_EQ(at(image, 2, 1), 50);
  EXPECT_EQ(at(image, 5, 4), 50);
  EXPECT_EQ(at(image, 6, 4), 10);
  EXPECT_EQ(at(image, 1, 1), 10);
  frame_box(box, image);
  EXPECT_NE(at(image, 2, 1), 50);
  EXPECT_NE(at(image, 5, 4), 50);
  EXPECT_EQ(at(image, 3, 2), 50);
  EXPECT_EQ(at(image, 1, 1), 10);
}

}  // namespace
}  // namespace thinwall
