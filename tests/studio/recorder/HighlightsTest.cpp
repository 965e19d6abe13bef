#include "studio/recorder/Highlights.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace thinwall {
namespace {

Image shade(std::uint8_t level) {
  return {.size = {.width = 2, .height = 2}, .pixels = std::vector<std::uint8_t>(12, level)};
}

TEST(HighlightsTest, ThePosterHasTheLargestForceAndIsTheFirstOfEquals) {
  Highlights highlights;
  for (const auto& [time, force] :
       {std::pair(0.0, 1.0), std::pair(1.0, 3.0), std::pair(2.0, 3.0), std::pair(3.0, 2.0)}) {
    highlights.add({.image = shade(static_cast<std::uint8_t>(time)), .time = time, .force = force});
  }
  EXPECT_EQ(highlights.poster_time(), 1);
  EXPECT_EQ(highlights.poster().pixels, shade(1).pixels);
}

TEST(HighlightsTest, FewFramesAreAllOnTheSheet) {
  Highlights highlights;
  for (int i = 0; i < 7; ++i) highlights.add({.image = shade(0), .time = static_cast<double>(i)});
  EXPECT_EQ(highlights.sheet_frames().size(), 7U);
}

TEST(HighlightsTest, CardsAndFreezesTakeOnePictureOfTheSheet) {
  Highlights highlights;
  for (const double time : {0, 0, 0, 0, 1, 2, 2, 2, 3, 3}) highlights.add({.image = shade(0), .time = time});
  std::vector<double> times;
  for (const SheetFrame& frame : highlights.sheet_frames()) times.push_back(frame.time);
  EXPECT_EQ(times, (std::vector<double>{0, 1, 2, 3}));
}

TEST(HighlightsTest, TheSheetShowsAMomentWithoutTheCardThatComesOverIt) {
  Highlights highlights;
  std::uint8_t level = 0;
  for (const auto& [time, covered] :
       {std::pair(0.0, 1.0), {0.0, 0.5}, {0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}}) {
    highlights.add({.image = shade(level++), .time = time, .covered = covered});
  }
  std::vector<std::uint8_t> shown;
  for (const SheetFrame& frame : highlights.sheet_frames()) shown.push_back(frame.picture.pixels.front());
  EXPECT_EQ(shown, (std::vector<std::uint8_t>{2, 3, 4}));
}

TEST(HighlightsTest, AMomentThatIsSeenUnderACardAloneIsNotOnTheSheetUnlessItIsTheFirst) {
  Highlights highlights;
  for (const auto& [time, covered] : {std::pair(0.0, 0.1), {1.0, 0.0}, {2.0, 0.05}, {2.0, 1.0}, {2.0, 0.02}}) {
    highlights.add({.image = shade(0), .time = time, .covered = covered});
  }
  std::vector<double> times;
  for (const SheetFrame& frame : highlights.sheet_frames()) times.push_back(frame.time);
  EXPECT_EQ(times, (std::vector<double>{0, 1}));
}

TEST(HighlightsTest, ManyFramesAreSpreadEvenlyOverTheSheet) {
  for (const int frames : {13, 95, 96, 97, 500, 5000}) {
    Highlights highlights;
    for (int i = 0; i < frames; ++i) highlights.add({.image = shade(0), .time = static_cast<double>(i)});
    const std::vector<SheetFrame> sheet = highlights.sheet_frames();
    ASSERT_EQ(sheet.size(), 12U);
    EXPECT_EQ(sheet.front().time, 0);
    const double even = (frames - 1) / 11.0;
    for (std::size_t i = 0; i < sheet.size(); ++i) {
      // Kept frames lie at most a fortieth of the whole apart, once there are so many that some are dropped.
      EXPECT_NEAR(sheet[i].time, static_cast<double>(i) * even, 0.5 + frames / 40.0)
          << frames << " frames, picture " << i;
    }
  }
}

}  // namespace
}  // namespace thinwall
