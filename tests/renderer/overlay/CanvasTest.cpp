#include "renderer/overlay/Canvas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

TEST(Canvas, TransparentLeavesThePictureAlone) {
  Image image = patterned_image({8, 8});
  Canvas({8, 8}).blend_onto(image, 0, 0);
  EXPECT_EQ(image.pixels, patterned_image({8, 8}).pixels);
}

TEST(Canvas, OpaqueReplacesThePicture) {
  Image image = patterned_image({4, 4});
  const Canvas canvas({4, 4});
  canvas.fill({1, 0, 0.2});
  canvas.blend_onto(image, 0, 0);
  EXPECT_EQ(image.pixels, plain_image({4, 4}, 255, 0, 51).pixels);
}

TEST(Canvas, HalfOpaqueIsTheMean) {
  Image image = plain_image({1, 1}, 200, 100, 0);
  const Canvas canvas({1, 1});
  canvas.fill({1, 1, 1, 0.2});  // 51 of 255
  canvas.blend_onto(image, 0, 0);
  EXPECT_EQ(image.pixels, (std::vector<std::uint8_t>{211, 131, 51}));
}

TEST(Canvas, WhatLiesOutsideIsCutOff) {
  const Canvas canvas({3, 3});
  canvas.fill({1, 1, 1});
  for (const auto& [left, top] : {std::pair{-2, -2}, {3, 3}, {-2, 3}, {3, -2}}) {
    Image image = plain_image({4, 4}, 0, 0, 0);
    canvas.blend_onto(image, left, top);
    EXPECT_EQ(std::count(image.pixels.begin(), image.pixels.end(), 255), 3) << left << ' ' << top;
  }
  Image image = plain_image({4, 4}, 0, 0, 0);
  canvas.blend_onto(image, 4, 0);
  canvas.blend_onto(image, 0, -3);
  EXPECT_EQ(image.pixels, plain_image({4, 4}, 0, 0, 0).pixels);
}

}  // namespace
}  // namespace thinwall
