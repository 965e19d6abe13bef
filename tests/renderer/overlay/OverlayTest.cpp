#include "renderer/overlay/Overlay.hpp"
#include "renderer/overlay/Plate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>
#include <utility>

#include "renderer/image/ImageHash.hpp"
#include "renderer/video/Program.hpp"
#include "tests/renderer/image/TestFolder.hpp"
#include "tests/renderer/overlay/OverlayContents.hpp"

namespace thinwall {
namespace {

/// A part of a picture, in fractions of its width and height.
struct Part {
  double left, top, right, bottom;
};

/// How many pixels of the part differ from the untouched ground.
int ink(const Image& image, const Part& part) {
  int count = 0;
  for (int y = 0; y < image.size.height; ++y) {
    for (int x = 0; x < image.size.width; ++x) {
      const double across = (x + 0.5) / image.size.width;
      const double down = (y + 0.5) / image.size.height;
      if (across < part.left || across > part.right || down < part.top || down > part.bottom) continue;
      const std::uint8_t* pixel = &image.pixels[3 * static_cast<std::size_t>(y * image.size.width + x)];
      count += pixel[0] != 90 || pixel[1] != 60 || pixel[2] != 50;
    }
  }
  return count;
}

constexpr Part kTitle{0, 0, 0.3, 0.15};
constexpr Part kTime{0.85, 0, 1, 0.15};
constexpr Part kGauge{0, 0.7, 0.25, 1};
constexpr Part kPlot{0.7, 0.7, 1, 1};
constexpr Part kCaption{0.35, 0.8, 0.65, 1};
constexpr Part kCenter{0, 0.16, 1, 0.7};
constexpr Part kWhole{0, 0, 1, 1};

TEST(Overlay, SameContentGivesTheSameBytes) {
  EXPECT_EQ(overlaid(some_content()).pixels, overlaid(some_content()).pixels);
}

TEST(Overlay, NothingDrawnBeforeMatters) {
  OverlayContent other = some_content();
  other.title = "Another title";
  other.caption = "Another caption";
  for (const auto& [content, size] :
       {std::pair{some_content(), kSize}, {other, kSize}, {other, ImageSize{640, 360}}, {some_content(), kSize}}) {
    const Image found = overlaid(content, size);
    Image fresh;  // a new thread remembers nothing
    std::thread([&, &shown = content, &shown_size = size] { fresh = overlaid(shown, shown_size); }).join();
    EXPECT_EQ(found.pixels, fresh.pixels);
  }
}

/// Not a test by itself: a fresh process runs it, because fonts are loaded once in a process.
TEST(Overlay, DISABLED_PrintsItsHash) {
  std::cout << "hash " << image_hash(overlaid(some_content())) << "\n";
}

TEST(Overlay, FontSettingsAndLanguageOfTheMachineTakeNoPart) {
  const TestFolder folder;
  std::ofstream(folder / "fonts.conf")
      << "<fontconfig><dir>/usr/share/fonts</dir><match target=\"pattern\"><edit name=\"family\" mode=\"assign\">"
         "<string>Inter Display</string></edit></match><match target=\"font\"><edit name=\"antialias\" mode=\"assign\">"
         "<bool>false</bool></edit></match></fontconfig>";
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const ProgramResult result =
      run_program({"env", "FONTCONFIG_FILE=" + (folder / "fonts.conf").string(), "LC_ALL=tr_TR.UTF-8", self,
                   "--gtest_filter=Overlay.DISABLED_PrintsItsHash", "--gtest_also_run_disabled_tests"});
  EXPECT_NE(result.output.find("hash " + image_hash(overlaid(some_content())) + "\n"), std::string::npos)
      << result.output;
}

TEST(Overlay, EachPartIsAtItsPlace) {
  const Image image = overlaid(some_content());
  for (const Part& part : {kTitle, kTime, kGauge, kPlot, kCaption}) EXPECT_GT(ink(image, part), 500);
}

TEST(Overlay, CenterStaysFree) {
  for (const ImageSize size : {kSize, ImageSize{640, 360}, ImageSize{1920, 1080}}) {
    EXPECT_EQ(ink(overlaid(some_content(), size), kCenter), 0);
  }
}

TEST(Overlay, NothingToShowChangesNothing) {
  EXPECT_EQ(ink(overlaid(nothing()), kWhole), 0);
}

TEST(Overlay, EachPartIsDrawnOnlyWhenAskedFor) {
  OverlayContent content = some_content();
  content.shown.force_plot = false;
  EXPECT_EQ(ink(overlaid(content), kPlot), 0);
  content = some_content();
  content.shown.gauge = false;
  EXPECT_EQ(ink(overlaid(content), kGauge), 0);
  content = some_content();
  content.shown.captions = false;
  EXPECT_EQ(ink(overlaid(content), kCaption), 0);
  content = some_content();
  content.shown.time = false;
  EXPECT_EQ(ink(overlaid(content), kTime), 0);
  content = some_content();
  content.title = "";
  EXPECT_EQ(ink(overlaid(content), kTitle), 0);
}

TEST(Overlay, TimePlateStandsStill) {
  OverlayContent content = nothing();
  content.shown.time = true;
  content.duration = 12;
  const auto plate_ink = [&](double time) {
    content.time = time;
    return ink(overlaid(content), kWhole);
  };
  EXPECT_EQ(plate_ink(1.11), plate_ink(11.99));
}

TEST(Overlay, LongCaptionStaysBetweenGaugeAndPlot) {
  OverlayContent content = some_content();
  for (int i = 0; i < 200; ++i) content.caption += " and it goes on";
  const Image image = overlaid(content);
  EXPECT_EQ(ink(image, kCenter), 0);
  EXPECT_EQ(ink(image, {0.215, 0.7, 0.235, 1}), 0);
  EXPECT_EQ(ink(image, {0.765, 0.7, 0.777, 1}), 0);
}

TEST(Overlay, PanelsLeaveTheRoundPictureOfAnEndoscopeFree) {
  OverlayContent content = some_content();
  content.shown.captions = false;
  const Image image = overlaid(content), untouched = plain_image(kSize, 90, 60, 50);
  const double radius = 0.56 * kSize.height;  // of the field stop, see Camera.cpp
  int covered = 0;
  for (int y = kSize.height / 2; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (std::hypot(x + 0.5 - 0.5 * kSize.width, y + 0.5 - 0.5 * kSize.height) > radius) continue;
      const std::size_t pixel = 3 * static_cast<std::size_t>(y * kSize.width + x);
      covered += image.pixels[pixel] != untouched.pixels[pixel] ? 1 : 0;
    }
  }
  EXPECT_EQ(covered, 0);
  EXPECT_GT(ink(image, kGauge), 10000);
  EXPECT_GT(ink(image, kPlot), 10000);
}

TEST(Overlay, LongTitleStopsBeforeTheTime) {
  OverlayContent content = some_content();
  content.title = std::string(300, 'W');
  EXPECT_EQ(ink(overlaid(content), {0.89, 0, 0.905, 0.15}), 0);
}

TEST(Overlay, PlotShowsTheHistoryAndNothingElseDoes) {
  OverlayContent content = some_content();
  content.history[300].force = 0.05;
  const Image changed = overlaid(content);
  const Image plain = overlaid(some_content());
  EXPECT_NE(changed.pixels, plain.pixels);
  for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
    if (changed.pixels[i] == plain.pixels[i]) continue;
    ASSERT_GT(static_cast<int>(i / 3) % kSize.width, 0.7 * kSize.width);
    ASSERT_GT(static_cast<int>(i / 3) / kSize.width, 0.7 * kSize.height);
  }
}

/// Pixels of the plot with the violet of the second tool.
int violet(const Image& image) {
  int count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    const std::uint8_t* pixel = &image.pixels[i];
    count += pixel[2] > 170 && pixel[2] > pixel[0] + 15 && pixel[0] > pixel[1] + 15;
  }
  return count;
}

TEST(Overlay, SeveralToolsHaveALineAndANameEachWhoseColorsStayWhicheverIsShown) {
  OverlayContent content = some_content();
  EXPECT_EQ(violet(overlaid(content)), 0);
  content.other_tools = {{.tool = "needle", .number = 1, .samples = {{0, 0}, {1, 0.1}, {2, 0.05}}}};
  EXPECT_GT(violet(overlaid(content)), 150) << "a line and what names it";
  std::swap(content.history, content.other_tools[0].samples);
  std::swap(content.tool, content.other_tools[0].tool);
  std::swap(content.tool_number, content.other_tools[0].number);
  EXPECT_GT(violet(overlaid(content)), 150);
}

TEST(Overlay, TellsNoPressureWhereNothingHasContents) {
  OverlayContent content = some_content();
  const Image with = overlaid(content);
  content.pressure.reset();
  const Image without = overlaid(content);
  int differ = 0;
  for (std::size_t i = 0; i < with.pixels.size(); ++i) {
    if (with.pixels[i] == without.pixels[i]) continue;
    ++differ;
    const std::size_t pixel = i / 3;
    const double across = static_cast<double>(pixel % kSize.width) / kSize.width;
    const double down = static_cast<double>(pixel) / (static_cast<double>(kSize.width) * kSize.height);
    EXPECT_TRUE(across > 0.11 && across < 0.21 && down > 0.88 && down < 0.955) << "beside the number and its name";
  }
  EXPECT_GT(differ, 500);
}

TEST(Overlay, NamesTheBodyThatAPressureIsOfWithinTheGauge) {
  OverlayContent content = some_content();
  const Image unnamed = overlaid(content);
  content.pressurized_body = "cyst";
  const Image cyst = overlaid(content);
  content.pressurized_body = "vessel";
  EXPECT_NE(cyst.pixels, unnamed.pixels);
  EXPECT_NE(overlaid(content).pixels, cyst.pixels);
  content.pressurized_body = std::string(100, 'x');
  const Image longest = overlaid(content);
  for (std::size_t i = 0; i < longest.pixels.size(); ++i) {
    const double across = static_cast<double>(i / 3 % kSize.width) / kSize.width;
    ASSERT_TRUE(longest.pixels[i] == unnamed.pixels[i] || (across > 0.08 && across < 0.21)) << "beside the depth";
  }
}

TEST(Overlay, TakesEmptyAndExtremeContent) {
  OverlayContent content = some_content();
  content.history.clear();
  EXPECT_GT(ink(overlaid(content), kPlot), 500);
  content.duration = 0;
  content.time = 0;
  overlaid(content);
  for (const double value : {1e-300, 1e-9, 1e6, 1e15, -1e15}) {
    content = some_content();
    content.force = content.depth = value;
    content.pressure = value;
    content.duration = std::abs(value);
    for (ForceSample& sample : content.history) sample.force = value;
    content.tool = std::string(100, 'x');
    content.phase = "a phase of another kind";
    EXPECT_EQ(ink(overlaid(content), kCenter), 0) << value;
  }
}

TEST(Overlay, TakesPicturesOfAnySize) {
  for (const ImageSize size : {ImageSize{1, 1}, {2, 2}, {16, 16}, {3000, 8}, {8, 3000}, {480, 640}}) {
    EXPECT_EQ(overlaid(some_content(), size).pixels.size(), static_cast<std::size_t>(size.width * size.height * 3));
  }
}

TEST(Overlay, ALongTitleEndsBeforeTheBadge) {
  OverlayContent content = nothing();
  content.shown.time = true;
  content.badge = "Slow motion \u00d70.25";
  const Image badge = overlaid(content);
  content.title =
      "A title that is so long that it would reach to the right border of the picture, and under all else "
      "that stands at the top of it";
  const Image both = overlaid(content);
  const int from = 960;  // pixels, left of the badge
  for (int y = 0; y < 80; ++y) {
    const auto row = 3 * (static_cast<std::ptrdiff_t>(y) * kSize.width);
    EXPECT_TRUE(std::equal(both.pixels.begin() + row + 3 * from, both.pixels.begin() + row + 3 * kSize.width,
                           badge.pixels.begin() + row + 3 * from))
        << y;
  }
}

TEST(Overlay, TheTitleIsTheSameWithAndWithoutTheBadge) {
  const auto title_part = [](const std::string& badge) {
    constexpr ImageSize kHigh{720, 1280};
    OverlayContent content = nothing();
    content.shown.time = true;
    content.title = "Puncture of the gallbladder, seen from near";
    content.badges_to_come = {"Paused", "Slow motion \u00d70.25"};
    content.badge = badge;
    const Image image = overlaid(content, kHigh);
    const int width = 392;  // left of the widest badge
    std::vector<std::uint8_t> part;
    for (int y = 0; y < 80; ++y) {
      const auto row = image.pixels.begin() + 3 * static_cast<std::ptrdiff_t>(y) * kHigh.width;
      part.insert(part.end(), row, row + 3 * width);
    }
    return part;
  };
  EXPECT_TRUE(title_part("") == title_part("Slow motion \u00d70.25"));
  EXPECT_TRUE(title_part("") == title_part("Paused"));
}

TEST(Overlay, LeavesAnInsetAsItIs) {
  struct Place {
    ImageSize size;
    Box inset;
  };
  // Wide, with the legend at the inset's height; narrow, with the caption above the panels.
  for (const auto& [size, inset] : {Place{{1280, 720}, {870, 78, 384, 216}}, Place{{1280, 720}, {870, 294, 384, 216}},
                                    Place{{720, 720}, {26, 294, 216, 216}}}) {
    OverlayContent content = some_content();
    content.legend = Legend{.title = "Stress", .unit = "Pa", .from = 0, .to = 1000};
    Image image = plain_image(size, 90, 60, 50);
    const Image before = image;
    draw_overlay(image, content, inset);
    int changed = 0;
    for (int y = static_cast<int>(inset.y); y < inset.bottom(); ++y) {
      const auto row = 3 * (static_cast<std::ptrdiff_t>(y) * size.width + static_cast<std::ptrdiff_t>(inset.x));
      changed += !std::equal(image.pixels.begin() + row, image.pixels.begin() + row + 3 * static_cast<int>(inset.width),
                             before.pixels.begin() + row);
    }
    EXPECT_EQ(changed, 0) << size.width << ' ' << inset.y;
  }
}

TEST(Overlay, ALongTitleIsWholeInAPictureThatIsHigherThanWide) {
  const auto pixels = [](const std::string& last) {
    OverlayContent content = some_content();
    content.title = "Examination of the gallbladder below the costal arch, part " + last;
    return overlaid(content, {540, 960}).pixels;
  };
  EXPECT_TRUE(pixels("one") != pixels("two"));
}

TEST(Overlay, TellsWhichTextsAreCut) {
  OverlayContent content = nothing();
  content.shown.captions = true;
  content.title = "Incision";
  content.caption = "The wall gives way";
  Image image = plain_image(kSize, 90, 60, 50);
  EXPECT_TRUE(draw_overlay(image, content).empty());
  for (int k = 0; k < 200; ++k) content.caption += " and the blade goes on";
  EXPECT_EQ(draw_overlay(image, content), std::vector<std::string>{content.caption});
  // From what is remembered of the frame before, too.
  EXPECT_EQ(draw_overlay(image, content), std::vector<std::string>{content.caption});
  for (int k = 0; k < 200; ++k) content.title += " of a wall";
  EXPECT_EQ(draw_overlay(image, content), (std::vector<std::string>{content.title, content.caption}));
}

TEST(Overlay, LettersOfSmallPicturesAreLargerThanTheirSizeAsks) {
  const auto letters = [](ImageSize size) { return OverlayGrid(size).pixels(20); };
  EXPECT_EQ(letters({1280, 720}), 20);
  EXPECT_EQ(letters({640, 360}), 10);
  EXPECT_EQ(letters({426, 240}), 10) << "they were 6.7 pixels high";
  EXPECT_EQ(letters({320, 180}), 7.5);
  // Both panels find room side by side also where it is narrow.
  EXPECT_LT(letters({240, 240}), 7);
}

}  // namespace
}  // namespace thinwall
