#include "renderer/overlay/ContactSheet.hpp"

#include <gtest/gtest.h>

#include "renderer/image/Resize.hpp"
#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

/// Whether `picture` stands in `sheet` with its top left at (left, top).
bool shows(const Image& sheet, const Image& picture, int left, int top) {
  for (int y = 0; y < picture.size.height; ++y) {
    for (int i = 0; i < 3 * picture.size.width; ++i) {
      const auto at = static_cast<std::size_t>(3 * ((top + y) * sheet.size.width + left) + i);
      if (sheet.pixels[at] != picture.pixels[static_cast<std::size_t>(3 * y * picture.size.width + i)]) return false;
    }
  }
  return true;
}

TEST(ContactSheet, PicturesStandInReadingOrder) {
  std::vector<SheetFrame> frames;
  for (int i = 0; i < 5; ++i) {
    frames.push_back({plain_image({160, 90}, static_cast<std::uint8_t>(40 * i), 100, 50), i * 0.5});
  }
  frames[4].picture = patterned_image({160, 90});
  const Image sheet = contact_sheet("Title", frames, 3, 80);
  EXPECT_EQ(sheet.size, (ImageSize{2 * 24 + 3 * 80 + 2 * 16, 2 * 24 + 44 + 2 * (45 + 30) + 16}));
  EXPECT_TRUE(shows(sheet, resize(frames[0].picture, {80, 45}), 24, 68));
  EXPECT_TRUE(shows(sheet, resize(frames[2].picture, {80, 45}), 24 + 2 * 96, 68));
  EXPECT_TRUE(shows(sheet, resize(frames[4].picture, {80, 45}), 24 + 96, 68 + 91));
}

TEST(ContactSheet, FewPicturesMakeANarrowSheet) {
  const Image sheet = contact_sheet("Title", {{plain_image({160, 90}, 1, 2, 3), 0}}, 4, 80);
  EXPECT_EQ(sheet.size.width, 128);
}

TEST(ContactSheet, TimesAreWrittenBelow) {
  const std::vector<SheetFrame> one{{plain_image({160, 90}, 1, 2, 3), 1.25}};
  const std::vector<SheetFrame> other{{plain_image({160, 90}, 1, 2, 3), 2.5}};
  EXPECT_NE(contact_sheet("Title", one).pixels, contact_sheet("Title", other).pixels);
  EXPECT_EQ(contact_sheet("Title", one).pixels, contact_sheet("Title", one).pixels);
}

TEST(ContactSheet, NoPicturesMakeATitle) {
  EXPECT_GT(contact_sheet("Title", {}).size.height, 44);
}

}  // namespace
}  // namespace thinwall
