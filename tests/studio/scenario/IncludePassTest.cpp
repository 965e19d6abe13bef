#include "studio/scenario/IncludePass.hpp"

#include <gtest/gtest.h>

#include "tests/studio/scenario/ScenarioTestTools.hpp"

namespace thinwall {
namespace {

/// A folder of files that is gone after the test.
class IncludePass : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / ("thinwall_include_" + std::string(info->name()));
    std::filesystem::create_directories(folder_ / "inner");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  TextNode include(const std::string& text) {
    write("main.yaml", text);
    TextNode root = read_yaml_file(folder_ / "main.yaml", diagnostics_).value_or(TextNode{});
    include_pass(root, diagnostics_);
    return root;
  }

  std::filesystem::path folder_;
  Diagnostics diagnostics_;
};

TEST_F(IncludePass, MappingsAreMergedKeyByKeyAndTheNearestWins) {
  write("far.yaml", "look: { a: far, b: far, list: [1, 2] }\nonly: far\n");
  write("near.yaml", "look: { b: near, c: near }\n");
  const TextNode root = include("include: [far.yaml, near.yaml]\nlook: { c: own, list: [3] }\n");
  const TextNode& look = root.find("look")->value;
  EXPECT_EQ(look.find("a")->value.text, "far");
  EXPECT_EQ(look.find("b")->value.text, "near");
  EXPECT_EQ(look.find("c")->value.text, "own");
  EXPECT_EQ(look.find("list")->value.items.size(), 1U);
  EXPECT_EQ(root.find("only")->value.text, "far");
  EXPECT_EQ(root.find("include"), nullptr);
  EXPECT_TRUE(diagnostics_.errors.empty());
}

TEST_F(IncludePass, FilesAreFoundFromTheFileThatNamesThem) {
  write("inner/one.yaml", "include: two.yaml\none: 1\n");
  write("inner/two.yaml", "two: 2\n");
  const TextNode root = include("include: inner/one.yaml\n");
  ASSERT_NE(root.find("two"), nullptr);
  EXPECT_EQ(root.find("two")->value.location.file, folder_ / "inner/two.yaml");
}

TEST_F(IncludePass, AllFilesAreOfOneVersion) {
  write("old.yaml", "include: older.yaml\nthinwall: 1\n");
  write("older.yaml", "one: 1\nthinwall: 2\n");
  include("thinwall: 1\ninclude: old.yaml\n");
  ASSERT_EQ(diagnostics_.errors.size(), 1U);
  EXPECT_EQ(diagnostics_.errors[0].location.file, folder_ / "older.yaml");
  EXPECT_EQ(diagnostics_.errors[0].location.line, 2);
  EXPECT_EQ(diagnostics_.errors[0].message,
            "thinwall: the file is of version `2`, that which includes it of `1`: a scenario is of one version");
}

TEST_F(IncludePass, AMappingOfAnotherKindReplacesTheFartherOne) {
  write("base.yaml", "a: { law: gum, x: 1 }\nb: { law: gum, x: 1 }\nc: { shape: ball, radius: 1 }\n");
  const TextNode root =
      include("include: base.yaml\na: { law: tar, y: 2 }\nb: { law: gum, y: 2 }\nc: { mesh: m.obj }\n");
  EXPECT_EQ(root.find("a")->value.find("x"), nullptr);
  EXPECT_NE(root.find("b")->value.find("x"), nullptr);
  EXPECT_EQ(root.find("c")->value.find("radius"), nullptr);
}

TEST_F(IncludePass, AFieldOfAnotherFormReplacesTheFartherOne) {
  write("base.yaml", "a: { default: 1, regions: [] }\nb: { default: 1, regions: [] }\nc: { along: 1, values: 2 }\n");
  const TextNode root =
      include("include: base.yaml\na: { file: a.csv, column: h }\nb: { default: 2 }\nc: { attribute: h }\n");
  EXPECT_EQ(root.find("a")->value.find("regions"), nullptr);
  EXPECT_NE(root.find("b")->value.find("regions"), nullptr);
  EXPECT_EQ(root.find("c")->value.find("values"), nullptr);
}

TEST_F(IncludePass, ACycleIsAnErrorAndTheSameFileTwiceIsNone) {
  write("a.yaml", "include: [b.yaml]\n");
  write("b.yaml", "include: [./inner/../a.yaml]\n");
  write("leaf.yaml", "x: 1\n");
  include("include: [a.yaml, leaf.yaml, leaf.yaml]\n");
  ASSERT_EQ(diagnostics_.errors.size(), 1U);
  EXPECT_EQ(diagnostics_.errors[0].message, "include[1]: `./inner/../a.yaml` includes itself; leave it out");
  EXPECT_EQ(diagnostics_.errors[0].location.file, folder_ / "b.yaml");
}

TEST_F(IncludePass, ATreeOfTooManyFilesIsRefusedOnce) {
  write("0.yaml", "x: 1\n");
  for (int level = 1; level < 10; ++level) {
    const std::string below = std::to_string(level - 1) + ".yaml";
    write(std::to_string(level) + ".yaml", "include: [" + below + ", " + below + "]\n");
  }
  include("include: 9.yaml\n");
  ASSERT_EQ(diagnostics_.errors.size(), 1U);
  EXPECT_EQ(diagnostics_.errors[0].message, "include[2]: more than 64 files are included");
}

TEST_F(IncludePass, WhatCannotBeIncludedIsToldAtItsPlaceInTheList) {
  write("list.yaml", "- 1\n");
  include("include: [none.yaml, list.yaml, [a], \"${file}\", inner]\n");
  EXPECT_EQ(diagnostics_.errors.size(), 5U);
  const std::vector<std::string> errors = short_texts(diagnostics_.errors);
  EXPECT_EQ(errors[0], "1:33: include[3]: expected the path of a file, got a list");
  EXPECT_TRUE(errors[1].starts_with("1:11: include[1]: there is no file `")) << errors[1];
  EXPECT_EQ(errors[2], "1:22: include[2]: `list.yaml` does not hold a mapping");
  EXPECT_EQ(errors[3],
            "1:38: include[4]: parameters are not known yet where files are included; write the file's name itself");
  EXPECT_TRUE(errors[4].starts_with("1:49: include[5]: `")) << errors[4];
}

TEST_F(IncludePass, AFileThatIsNamedWithoutAListHasNoPlaceInOne) {
  include("include: none.yaml\n");
  ASSERT_EQ(diagnostics_.errors.size(), 1U);
  EXPECT_TRUE(diagnostics_.errors[0].message.starts_with("include: there is no file `"));
}

}  // namespace
}  // namespace thinwall
