#include "studio/schema/Wording.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

const std::vector<std::string> kWords = {"thickness", "density", "material", "at", "to"};

TEST(Wording, TheNearestWordIsFoundThroughOneMistakeOfAnyKind) {
  EXPECT_EQ(nearest_word("thicknes", kWords), "thickness");
  EXPECT_EQ(nearest_word("thicknness", kWords), "thickness");
  EXPECT_EQ(nearest_word("thickmess", kWords), "thickness");
  EXPECT_EQ(nearest_word("densiyt", kWords), "density");
  EXPECT_EQ(nearest_word("Density", kWords), "density");
}

TEST(Wording, AWordThatIsFarFromAllIsTakenForNone) {
  EXPECT_EQ(nearest_word("viscosity", kWords), "");
  EXPECT_EQ(nearest_word("x", kWords), "");
  EXPECT_EQ(nearest_word(std::string(100000, 'a'), kWords), "");
  EXPECT_EQ(did_you_mean("viscosity", kWords), "");
}

TEST(Wording, QuotedTextStaysOnOneLineAndIsCutBetweenCharacters) {
  EXPECT_EQ(in_backticks("a\nb\x01"), "`a\\nb\\x01`");
  EXPECT_EQ(in_backticks(std::string(59, 'x') + "éé"), "`" + std::string(59, 'x') + "...`");
  EXPECT_EQ(in_backticks(std::string(60, 'x')), "`" + std::string(60, 'x') + "`");
}

TEST(Wording, AShellTakesAnArgumentAsItIs) {
  EXPECT_EQ(shell_argument("scenes/a-1.yaml"), "scenes/a-1.yaml");
  EXPECT_EQ(shell_argument("my scene"), "'my scene'");
  EXPECT_EQ(shell_argument("the surgeon's $HOME"), "'the surgeon'\\''s $HOME'");
  EXPECT_EQ(shell_argument(""), "''");
}

TEST(Wording, APathIsQuotedWholeHoweverLong) {
  const std::string path = "/" + std::string(200, 'a') + "/organ.obj";
  EXPECT_EQ(path_in_backticks(path), "`" + path + "`");
  EXPECT_EQ(path_in_backticks("a\nb"), "`a\\nb`");
}

TEST(Wording, NamesHaveLettersDigitsAndUnderscores) {
  EXPECT_TRUE(is_name("organ_2-left"));
  EXPECT_FALSE(is_name(""));
  EXPECT_FALSE(is_name("2nd"));
  EXPECT_FALSE(is_name("a b"));
  EXPECT_FALSE(is_name("a/b"));
}

}  // namespace
}  // namespace thinwall
