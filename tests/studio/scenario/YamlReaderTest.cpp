#include "studio/scenario/YamlReader.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/studio/TemporaryFolder.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"

namespace thinwall {
namespace {

/// The first thing that is wrong with a text.
std::string first_error(const std::string& text) {
  Diagnostics diagnostics;
  read_yaml_text(text, "test.yaml", diagnostics);
  const std::vector<std::string> texts = short_texts(diagnostics.errors);
  return texts.empty() ? "" : texts[0];
}

TEST(YamlReader, EachNodeKnowsItsPlaceCountedFromOne) {
  Diagnostics diagnostics;
  const TextNode root = parse_text("a: 1\nb:\n  - { c: word }\n", diagnostics);
  const TextMember& b = *root.find("b");
  EXPECT_EQ(b.location.line, 2);
  EXPECT_EQ(b.location.column, 1);
  const TextMember& c = *b.value.items[0].find("c");
  EXPECT_EQ(c.location.line, 3);
  EXPECT_EQ(c.location.column, 7);
  EXPECT_EQ(c.value.location.column, 10);
  EXPECT_EQ(c.value.text, "word");
}

TEST(YamlReader, ColumnsCountCharactersNotBytes) {
  Diagnostics diagnostics;
  const TextNode root = parse_text("{ \"é€𝄞\": 1, b: 2 }", diagnostics);
  EXPECT_EQ(root.find("b")->location.column, 13);
}

TEST(YamlReader, WordsStayTexts) {
  Diagnostics diagnostics;
  const TextNode root = parse_text("[yes, 010, 1e3, 0x1F, \"~\", ~]", diagnostics);
  EXPECT_EQ(root.items[0].text, "yes");
  EXPECT_EQ(root.items[1].text, "010");
  EXPECT_EQ(root.items[4].text, "~");
  EXPECT_EQ(root.items[5].kind, NodeKind::kEmpty);
}

TEST(YamlReader, OfDuplicateKeysTheFirstIsKeptAndTheOthersAreErrors) {
  Diagnostics diagnostics;
  const TextNode root = parse_text("a:\n  - b: 1\n    b: 2\n    b: 3\n", diagnostics);
  EXPECT_EQ(root.find("a")->value.items[0].find("b")->value.text, "1");
  EXPECT_EQ(short_texts(diagnostics.errors),
            (std::vector<std::string>{"3:5: a[1].b: duplicate key, first given in line 2; leave one of both out",
                                      "4:5: a[1].b: duplicate key, first given in line 2; leave one of both out"}));
}

TEST(YamlReader, AliasesAreCopiedAndKeepThePlaceOfTheirAnchor) {
  Diagnostics diagnostics;
  const TextNode root = parse_text("a: &x [1, 2]\nb: *x\n", diagnostics);
  EXPECT_EQ(root.find("b")->value.items[1].text, "2");
  EXPECT_EQ(root.find("b")->value.items[1].location.line, 1);
}

TEST(YamlReader, AByteOrderMarkAndWindowsLinesAreRead) {
  Diagnostics diagnostics;
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "thinwall_yaml_reader_test.yaml";
  std::ofstream(file, std::ios::binary) << "\xEF\xBB\xBF"
                                        << "a: 1\r\nb: 2\r\n";
  const std::optional<TextNode> root = read_yaml_file(file, diagnostics);
  std::filesystem::remove(file);
  ASSERT_TRUE(root);
  EXPECT_EQ(root->find("b")->value.text, "2");
  EXPECT_EQ(root->find("a")->location.column, 1);
}

TEST(YamlReader, WhatCouldExhaustTheProgramIsRefused) {
  EXPECT_TRUE(first_error(std::string(100000, '[')).ends_with("nested more than 64 levels deep"));
  EXPECT_EQ(first_error("a: &a [*a]"), "1:8: an alias inside the value that it stands for");
  std::string many = "a: [";
  for (int count = 0; count < 100001; ++count) many += "0,";
  EXPECT_NE(first_error(many + "]").find("more than 100000 values"), std::string::npos);
}

TEST(YamlReader, WhatIsNoTextIsRefusedAtItsFirstByte) {
  EXPECT_EQ(first_error("a: \xC3\xA9\xFF"), "1:5: not a text file: this byte is no UTF-8; save the file in UTF-8");
  EXPECT_EQ(first_error("a: 1\nb: \xED\xA0\x80"),
            "2:4: not a text file: this byte is no UTF-8; save the file in UTF-8");
  EXPECT_EQ(first_error("a: \xC0\xAF"), "1:4: not a text file: this byte is no UTF-8; save the file in UTF-8");
  EXPECT_EQ(first_error("a: \xF5\x80\x80\x80"), "1:4: not a text file: this byte is no UTF-8; save the file in UTF-8");
  EXPECT_EQ(first_error(std::string("a: \0", 4)), "1:4: not a text file: a control character stands here");
}

TEST(YamlReader, TabsThatIndentAreNamedWhereTheFirstOfThemIs) {
  const std::string tab = ": this line is indented with a tab, which YAML does not allow; indent it with spaces";
  EXPECT_EQ(first_error("a:\n\tb:\n\t\tc: 1\n"), "2:1" + tab);
  EXPECT_EQ(first_error("a:\n  b:\n  \tc:\n  \t\td: 1\n"), "3:1" + tab);
  // Elsewhere they are blanks.
  EXPECT_EQ(first_error("a:\t1\nb: [1,\t2]\n"), "");
}

TEST(YamlReader, AQuotationMarkWithoutItsSecondDoesNotTakeTheRestOfTheFile) {
  const std::string unclosed =
      ": the quotation mark that begins here has no second one, so that all that follows is part of the text";
  EXPECT_EQ(first_error("a: \"words\nb: 1\n"), "1:4" + unclosed);
  EXPECT_EQ(first_error("a: 'it''s\nb: 1\n"), "1:4" + unclosed);
  EXPECT_EQ(first_error("b: [é, \"words \\\"]\n"), "1:8" + unclosed);
  EXPECT_EQ(first_error("a: &words 'b\n"), "1:4" + unclosed);
  EXPECT_EQ(first_error("a: 'it''s'\nb: \"a \\\" b\"\nc: it's\nd: &e \"f\"\n"), "");
}

TEST(YamlReader, WhereTheParserGivesUpTheLikelyCureIsTold) {
  const std::string colon = ": this is no YAML: illegal map value; ";
  EXPECT_EQ(first_error("title: Lesson 1: a balloon\n"),
            "1:16" + colon + "a text with `: ` in it needs quotation marks around it");
  EXPECT_EQ(first_error("a:\n  speed 2 mm/s\n\n  hold: 1 s\n"),
            "4:7" + colon + "in line 2 a key is to be followed by `:` and a space");
  EXPECT_EQ(
      first_error("a:\n  speed: 2 mm/s\n   hold: 1 s\n"),
      "3:8" + colon + "it is indented by 3 spaces, and line 2 by 2: keys of one mapping begin in the same column");
  EXPECT_EQ(
      first_error("a: { b: ${c}, d: 1 }\n"),
      "1:10: this is no YAML: end of map flow not found; a `,` or `}` is missing before this, or a text with `{`, "
      "`}`, `,` or `${` in it has no quotation marks around it");
  EXPECT_EQ(first_error("a: [1, 2\nb: 3\n"),
            "2:2: this is no YAML: end of sequence flow not found; `[` of line 1 is still open here: a `,` or `]` is "
            "missing before this");
  EXPECT_EQ(
      first_error("a:\n    b: 1\n  c: 2\n"),
      "3:3: this is no YAML: end of map not found; keys of one mapping begin in the same column, and each item of "
      "a list begins with `- `");
  EXPECT_EQ(first_error("a: { b: é, c: *thin }\n"),
            "1:15: this is no YAML: the referenced anchor is not defined; `*thin` stands for what `&thin` marks before "
            "it; a text that begins with `*` needs quotation marks around it");
  EXPECT_EQ(first_error("a: @home\n"),
            "1:4: this is no YAML: unknown token; a text that begins with `@` needs quotation marks around it");
  EXPECT_EQ(first_error("a: { b: 1 ]\n"),
            "1:11: this is no YAML: illegal flow end; `]` closes nothing that is open "
            "here: `{` goes with `}`, `[` with `]`");
}

TEST(YamlReader, ACommentThatIsMeantAsOneIsNoCauseOfWhatIsWrongBesideIt) {
  EXPECT_EQ(first_error("a: { b: 1, # in [mm] of {old}\n  c: *thin }\n"),
            "2:6: this is no YAML: the referenced anchor is not defined; `*thin` stands for what `&thin` marks before "
            "it; a text that begins with `*` needs quotation marks around it");
  EXPECT_EQ(first_error("a: { b: [1, # round {ball}\n  2 } }\n"),
            "2:5: this is no YAML: illegal flow end; `}` closes nothing that is open "
            "here: `{` goes with `}`, `[` with `]`");
}

TEST(YamlReader, ABracketThatIsStillOpenIsToldWithTheCommentThatHidesItsEnd) {
  const std::string cure = "is taken for a comment: a text with ` #` in it needs quotation marks around it";
  EXPECT_EQ(first_error("a:\n  - b: { c: Press #1, d: 1 }\n  - b: 2\n"),
            "3:3: this is no YAML: illegal block entry; `{` of line 2 is still open here, as `#1, d: 1 }` " + cure);
  EXPECT_EQ(first_error("a: { b: [left #1, right #2] }\nc: 1\n"),
            "2:1: this is no YAML: end of sequence flow not found; `[` of line 1 is still open here, as "
            "`#1, right #2] }` " +
                cure);
  EXPECT_EQ(
      first_error("a: { b: 'it''s } #', # first\n  c: [1]\nd: 2\n"),
      "3:1: this is no YAML: end of map flow not found; `{` of line 1 is still open here: a `,` or `}` is missing "
      "before this, or a text with `{`, `}`, `,` or `${` in it has no quotation marks around it");
}

TEST(YamlReader, WhatLooksLikeTheEndOfAPlainTextIsKeptBesideIt) {
  Diagnostics diagnostics;
  const TextNode root = parse_text(
      "a: Balloon #1\nb: &n Press\n  harder #2 now\nc: Press # first\nd: Press  #first\ne: \"Press\" #3\nf: C#1\n",
      diagnostics);
  EXPECT_EQ(root.find("a")->value.cut_off, "#1");
  EXPECT_EQ(root.find("b")->value.cut_off, "#2 now");
  for (const char* key : {"c", "d", "e", "f"}) EXPECT_EQ(root.find(key)->value.cut_off, "") << key;
}

TEST(YamlReader, ASpaceThatIsNoneForYamlIsNamed) {
  EXPECT_EQ(first_error("a:\n\u00A0\u00A0b: 1\n"),
            "2:1: this line is indented with a space that is none for YAML, as text processors set them; indent it "
            "with plain spaces");
}

TEST(YamlReader, WhatIsNoReadableFileIsRefused) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  Diagnostics diagnostics;
  EXPECT_FALSE(read_yaml_file(folder / "thinwall_no_such_file.yaml", diagnostics));
  EXPECT_FALSE(read_yaml_file(folder, diagnostics));
  EXPECT_FALSE(read_yaml_file("/dev/zero", diagnostics));
  const std::filesystem::path large = folder / "thinwall_yaml_reader_large.yaml";
  std::ofstream(large) << std::string((1 << 20) + 1, '#');
  EXPECT_FALSE(read_yaml_file(large, diagnostics));
  std::filesystem::remove(large);
  EXPECT_EQ(short_texts(diagnostics.errors),
            (std::vector<std::string>{"1:1: no such file", "1:1: this is a directory, not a file",
                                      "1:1: this is not a regular file", "1:1: the file is larger than 1 MiB"}));
}

TEST(YamlReader, AFileOfSomebodyElseIsSaidToBeOne) {
  const TemporaryFolder folder;
  write_bytes(folder / "mine.yaml", "thinwall: 1\n");
  Diagnostics diagnostics;
  const bool is_root = geteuid() == 0;
  const auto read_as_somebody_else = [&] {
    if (is_root && seteuid(65534) != 0) return;
    EXPECT_FALSE(read_yaml_file(folder / "mine.yaml", diagnostics));
    EXPECT_TRUE(!is_root || seteuid(0) == 0);
  };
  std::filesystem::permissions(folder / "mine.yaml", std::filesystem::perms::none);
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  read_as_somebody_else();
  std::filesystem::permissions(folder.path(), std::filesystem::perms::none);
  read_as_somebody_else();
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
  const std::string told = "1:1: the file cannot be read: Permission denied";
  EXPECT_EQ(short_texts(diagnostics.errors), (std::vector<std::string>{told, told}));
}

TEST(YamlReader, ATakeIsToldToBeOneHoweverLargeItIs) {
  const std::filesystem::path take = std::filesystem::temp_directory_path() / "thinwall_yaml_reader_take.h5";
  Diagnostics diagnostics;
  for (const std::size_t size : {100, 1 << 21}) {
    std::ofstream(take, std::ios::binary) << "\x89HDF\r\n\x1A\n" << std::string(size, 'x');
    EXPECT_FALSE(read_yaml_file(take, diagnostics));
  }
  std::filesystem::remove(take);
  const std::string told =
      "1:1: this is an HDF5 file, as takes are, and no scenario; `thinwall render` makes pictures of a take";
  EXPECT_EQ(short_texts(diagnostics.errors), (std::vector<std::string>{told, told}));
}

TEST(YamlReader, ALinkThatLeadsNowhereIsToldWithItsTarget) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  for (const char* target : {"nothing.yaml", "itself.yaml"}) {
    std::filesystem::create_symlink(target, folder / "itself.yaml");
    EXPECT_FALSE(read_yaml_file(folder / "itself.yaml", diagnostics));
    std::filesystem::remove(folder / "itself.yaml");
  }
  EXPECT_EQ(short_texts(diagnostics.errors),
            (std::vector<std::string>{"1:1: this is a link to `nothing.yaml`, which leads to no file",
                                      "1:1: this is a link to `itself.yaml`, which leads to no file"}));
}

TEST(YamlReader, KeysThatAreNoTextsAreErrors) {
  EXPECT_EQ(first_error("? [a]\n: 1\n"), "1:3: a key must be a text, not a list");
  EXPECT_EQ(first_error("a: { ~: 1 }"), "1:6: a: a key must be a text, not nothing");
}

}  // namespace
}  // namespace thinwall
