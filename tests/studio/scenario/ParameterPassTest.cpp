#include "studio/scenario/ParameterPass.hpp"

#include <gtest/gtest.h>

#include "tests/studio/scenario/ScenarioTestTools.hpp"

namespace thinwall {
namespace {

struct Filled {
  TextNode root;
  std::vector<std::string> errors;
  std::string text(const std::string& key) const { return root.find(key)->value.text; }
};

Filled fill(const std::string& text, const Overrides& overrides = {}) {
  Diagnostics diagnostics;
  Filled filled;
  filled.root = parse_text(text, diagnostics);
  parameter_pass(filled.root, overrides, diagnostics);
  filled.errors = short_texts(diagnostics.errors);
  return filled;
}

using Texts = std::vector<std::string>;

TEST(ParameterPass, FillsInTextsAloneAndInsideLongerTexts) {
  const Filled filled = fill("parameters: { a: 4 mm, b: two }\nx: ${a}\ny: from ${a} to ${b}.\n");
  EXPECT_EQ(filled.text("x"), "4 mm");
  EXPECT_EQ(filled.text("y"), "from 4 mm to two.");
  EXPECT_EQ(filled.errors, Texts{});
}

TEST(ParameterPass, AWholeListCanBeAParameter) {
  const Filled filled = fill("parameters: { p: [0, 0, \"${z}\"], z: 5 mm }\nx: ${p}\n");
  ASSERT_EQ(filled.root.find("x")->value.items.size(), 3U);
  EXPECT_EQ(filled.root.find("x")->value.items[2].text, "5 mm");
}

TEST(ParameterPass, AnOverrideTakesThePlaceOfTheDefaultEverywhere) {
  const Filled filled = fill("parameters: { a: 4 mm, b: \"${a}\" }\nx: ${b}\n", {{"a", "7 mm"}});
  EXPECT_EQ(filled.text("x"), "7 mm");
  EXPECT_EQ(filled.root.find("parameters")->value.find("a")->value.text, "7 mm");
  EXPECT_EQ(fill("parameters: { p: [1] }\nx: ${p}", {{"p", "[1, 2]"}}).root.find("x")->value.items.size(), 2U);
}

TEST(ParameterPass, AValueIsPlacedWhereItIsUsedAndSaysWhereItIsFrom) {
  const Filled filled = fill("parameters: { a: 4 mm }\nx: ${a}\n");
  EXPECT_EQ(filled.root.find("x")->value.location.line, 2);
  EXPECT_EQ(filled.root.find("x")->value.parameters, "`${a}` is `4 mm`");
}

TEST(ParameterPass, NamesThatNothingStandsForAreErrors) {
  EXPECT_EQ(fill("parameters: { depth: 1 }\nx: ${dept} ${depth}\ny: ${depth}\n").errors,
            Texts{"2:4: x: there is no parameter `dept`, did you mean `depth`?"});
  EXPECT_EQ(fill("parameters: { depth: 1, hold: 2 }\nx: ${depth} ${hold} ${law}\n").errors,
            Texts{"2:4: x: there is no parameter `law`; there is `depth`, `hold`"});
  EXPECT_EQ(fill("x: ${a}").errors,
            Texts{"1:4: x: there is no parameter `a`; there is none: `parameters: { a: ... }` gives it"});
  EXPECT_EQ(fill("x: ${a").errors, Texts{"1:4: x: expected `${name}` with the name of a parameter, got `${a`"});
  EXPECT_EQ(fill("x: \"${}\"").errors, Texts{"1:4: x: expected `${name}` with the name of a parameter, got `${}`"});
}

TEST(ParameterPass, ParametersAndOverridesThatNothingUsesAreErrors) {
  EXPECT_EQ(
      fill("parameters: { a: 1, b: \"${a}\" }").errors,
      (Texts{
          "1:15: parameters.a: nothing uses this parameter; write `${a}` where its value belongs, or leave it out",
          "1:21: parameters.b: nothing uses this parameter; write `${b}` where its value belongs, or leave it out"}));
  EXPECT_EQ(fill("parameters: { depth: 1 }\nx: ${depth}", {{"deth", "2"}}).errors,
            Texts{"1:1: `--set deth=2`: the scenario has no parameter `deth`, did you mean `depth`?"});
  EXPECT_EQ(
      fill("x: 1", {{"a", "2"}}).errors,
      Texts{"1:1: `--set a=2`: the scenario has no parameter `a`; there is none: `parameters: { a: ... }` gives it"});
  EXPECT_EQ(fill("parameters: { a: 1 }\nx: ${a}", {{"a", "2"}, {"a", "3"}}).errors,
            Texts{"1:1: `--set a=3`: `a` is set twice"});
}

TEST(ParameterPass, ParametersThatNeedThemselvesAreTold) {
  EXPECT_EQ(fill("parameters: { a: \"${b}\", b: \"x ${a}\" }\nx: ${a}\ny: ${b}\n").errors,
            Texts{"1:29: parameters.b: the parameter `a` needs itself"});
}

TEST(ParameterPass, GrowthWithoutBoundIsRefused) {
  std::string texts = "parameters:\n  a0: aaaaaaaaaaaaaaaa\n";
  std::string lists = "parameters:\n  a0: [1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int level = 1; level < 12; ++level) {
    const std::string below = "${a" + std::to_string(level - 1) + "}";
    const std::string name = "  a" + std::to_string(level) + ": ";
    texts += name + "\"x" + below + below + below + below + "\"\n";
    lists += name + "[\"" + below + "\", \"" + below + "\", \"" + below + "\", \"" + below + "\"]\n";
  }
  ASSERT_EQ(fill(texts + "x: ${a11}\n").errors.size(), 1U);
  EXPECT_NE(fill(texts + "x: ${a11}\n").errors[0].find("longer than 10000 bytes"), std::string::npos);
  ASSERT_GE(fill(lists + "x: ${a11}\n").errors.size(), 1U);
  EXPECT_NE(fill(lists + "x: ${a11}\n").errors[0].find("more than 100000 values"), std::string::npos);
}

}  // namespace
}  // namespace thinwall
