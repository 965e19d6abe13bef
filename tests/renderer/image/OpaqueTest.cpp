#include "renderer/image/Opaque.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace thinwall {
namespace {

TEST(LeaveOutAlpha, KeepsTheColoursOfAnyNumberOfPixelsAndWritesNothingBehindThem) {
  constexpr std::uint8_t kUntouched = 0xee;
  for (std::size_t pixels = 0; pixels < 40; ++pixels) {
    std::vector<std::uint8_t> with_alpha, expected;
    for (std::size_t i = 0; i < 4 * pixels; ++i) {
      with_alpha.push_back(static_cast<std::uint8_t>(i));
      if (i % 4 != 3) expected.push_back(static_cast<std::uint8_t>(i));
    }
    expected.push_back(kUntouched);
    std::vector<std::uint8_t> found(3 * pixels + 1, kUntouched);
    leave_out_alpha(with_alpha.data(), found.data(), pixels);
    EXPECT_EQ(found, expected) << pixels;
  }
}

}  // namespace
}  // namespace thinwall
