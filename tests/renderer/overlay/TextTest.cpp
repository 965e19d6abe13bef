#include "renderer/overlay/Text.hpp"

#include <gtest/gtest.h>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/overlay/Letters.hpp"
#include "tests/renderer/image/TestFolder.hpp"
#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {
namespace {

Image drawn(const Text& text) {
  Image image = plain_image({200, 40}, 0, 0, 0);
  const Canvas canvas(image.size);
  text.draw(canvas, 0, 0);
  canvas.blend_onto(image, 0, 0);
  return image;
}

TEST(Text, DigitsAreOfOneWidth) {
  EXPECT_EQ(Text("111.11", {.size = 20}).width(), Text("888.88", {.size = 20}).width());
}

TEST(Text, WidthGrowsWithTheSizeExactly) {
  // The font is not hinted, so nothing is rounded but to 1/1024 of a pixel for each letter.
  EXPECT_NEAR(Text("Palpation", {.size = 40}).width(), 2 * Text("Palpation", {.size = 20}).width(), 0.02);
}

TEST(Text, TooLongIsCutWithinTheWidth) {
  const Text text("a text that is much longer than its place", {.size = 20}, {.width = 100});
  EXPECT_TRUE(text.is_cut());
  EXPECT_EQ(text.lines(), 1);
  EXPECT_LE(text.width(), 100);
}

TEST(Text, WrapsWhereLinesAllow) {
  const Text text("a text that is longer than its place", {.size = 20}, {.width = 200, .lines = 3});
  EXPECT_FALSE(text.is_cut());
  EXPECT_EQ(text.lines(), 2);
  EXPECT_FALSE(text.has_broken_word());
}

TEST(Text, OneLongWordIsBroken) {
  const Text text(std::string(60, 'm'), {.size = 20}, {.width = 300, .lines = 9});
  EXPECT_GT(text.lines(), 1);
  EXPECT_TRUE(text.has_broken_word());
  EXPECT_LE(text.width(), 300);
}

TEST(Text, BytesThatAreNoTextAreShownAsSuch) {
  const Text broken("a\xff\xfe z", {.size = 20});
  EXPECT_GT(broken.width(), Text("a z", {.size = 20}).width());
}

TEST(Text, OtherScriptsAreDrawn) {
  for (const char* word : {"Ωμέγα", "Привет", "naïve", "漢字"}) {
    const Image image = drawn(Text(word, {.size = 20}));
    EXPECT_NE(image.pixels, plain_image(image.size, 0, 0, 0).pixels) << word;
  }
}

TEST(Text, TheScriptsOfMostReadersHaveShapes) {
  for (const char* word : {"胆囊", "胆嚢の触診", "담낭 촉진", "المرارة", "כיס המרה", "पित्ताशय", "পিত্তথলি", "பித்தப்பை",
                           "ถุงน้ำดี", "ნაღვლის", "լեղապարկ", "ሐሞት"}) {
    EXPECT_EQ(letters_without_shape(word), "") << word;
  }
}

TEST(Text, LinesOfChineseEndBetweenLettersButNotBeforeAStop) {
  const std::string sentence = "注意观察周围组织的变化和力的大小。";
  for (double width = 60; width < 330; width += 7) {
    const Text text(sentence, {.size = 20}, {.width = width, .lines = 9});
    EXPECT_FALSE(text.has_broken_word()) << width;
  }
}

TEST(Text, LettersThatTheFontHasNoShapeForAreNamedOnce) {
  EXPECT_EQ(letters_without_shape("Wall 2 mm \u2013 \u00b5m, \u03b1"), "");
  EXPECT_EQ(letters_without_shape("\u16a0 a \u16a0 \u16b1"), "\u16a0\u16b1");  // runes
}

TEST(Text, BoldIsAnotherFont) {
  EXPECT_GT(Text("Palpation", {.size = 20, .bold = true}).width(), Text("Palpation", {.size = 20}).width());
}

TEST(Font, NamesItsVersion) {
  EXPECT_TRUE(overlay_font().description().starts_with("Inter, font file version ")) << overlay_font().description();
}

TEST(Font, MissingFileIsNamedWithThePackage) {
  const TestFolder folder;
  try {
    const Font font(folder.path());
    FAIL();
  } catch (const PictureFailure& failure) {
    EXPECT_EQ(failure.what(),
              "cannot read the font " + (folder / "Inter-Regular.otf").string() +
                  ", which all texts on pictures are set in; install it (on Debian: apt-get install fonts-inter)");
  }
}

}  // namespace
}  // namespace thinwall
