#include "renderer/image/ImageHash.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

TEST(ImageHash, EqualPicturesHaveEqualHashesOfThirtyTwoDigits) {
  const Image image = patterned_image({31, 17});
  EXPECT_EQ(image_hash(image), image_hash(Image(image)));
  EXPECT_EQ(image_hash(image).size(), 32u);
  EXPECT_EQ(image_hash(image).find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(ImageHash, OneLevelInOnePixelChangesIt) {
  const Image image = patterned_image({31, 17});
  Image changed = image;
  changed.pixels.back() ^= 1;
  EXPECT_NE(image_hash(image), image_hash(changed));
}

TEST(ImageHash, SamePixelsInAnotherShapeHaveAnotherHash) {
  EXPECT_NE(image_hash(plain_image({20, 10}, 1, 2, 3)), image_hash(plain_image({10, 20}, 1, 2, 3)));
}

}  // namespace
}  // namespace thinwall
