#include "studio/scenario/ReferencePass.hpp"

#include <gtest/gtest.h>

#include "tests/studio/scenario/CheckedText.hpp"

namespace thinwall {
namespace {

using Texts = std::vector<std::string>;

Texts errors_of(const std::string& sections, const std::string& surface = "{ shape: sphere }") {
  CheckedValue root = checked_scenario(sections, surface);
  Diagnostics diagnostics;
  reference_pass(root, diagnostics);
  return short_texts(diagnostics.errors);
}

TEST(ReferencePass, NamesOfNothingAreErrors) {
  EXPECT_EQ(errors_of("timeline:\n  - palpate: { tool: prob, body: liver, depth: 1 mm }\n"),
            (Texts{"9:22: timeline[1].palpate.tool: there is no tool `prob`, did you mean `probe`?",
                   "9:34: timeline[1].palpate.body: there is no body `liver`; there is `organ`"}));
  EXPECT_EQ(errors_of("look: { bodies: { heart: {} } }\n"),
            Texts{"8:19: look.bodies.heart: there is no body `heart`; there is `organ`"});
}

TEST(ReferencePass, ALeftOutBodyIsTheOnlyOneAndALeftOutToolOfTwoIsAnError) {
  CheckedValue root =
      checked_scenario("timeline: [ palpate: { tool: probe, depth: 1 mm }, move: { to: [0, 0, 0] } ]\n");
  Diagnostics diagnostics;
  reference_pass(root, diagnostics);
  const CheckedValue& palpate = root.at("timeline").items[0].at("palpate");
  EXPECT_EQ(palpate.at("body").text, "organ");
  EXPECT_FALSE(palpate.at("body").given);
  EXPECT_EQ(short_texts(diagnostics.errors),
            Texts{"8:52: timeline[2].move: `tool` is missing; there is `probe`, `edge`"});
}

TEST(ReferencePass, ALeftOutBodyIsTheOnlyOneThatIsNotFixedAllOver) {
  const auto body_with = [](const std::string& fixed) {
    CheckedValue root = checked_scenario(
        "  table: { surface: { shape: disc }, wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 1 "
        "kPa } }, fixed: [ " +
        fixed + " ] }\ntimeline: [ palpate: { tool: probe, depth: 1 mm } ]\n");
    Diagnostics diagnostics;
    reference_pass(root, diagnostics);
    const CheckedValue* body = root.at("timeline").items[0].at("palpate").find("body");
    return body != nullptr ? body->text : diagnostics.errors.at(0).message;
  };
  EXPECT_EQ(body_with("{ region: { all: true } }"), "organ");
  const std::string choose = "timeline[1].palpate: `body` is missing; there is `organ`, `table`";
  EXPECT_EQ(body_with("{ region: { all: true }, axes: xy }"), choose);
  EXPECT_EQ(body_with("{ region: { boundary: true } }"), choose);
}

TEST(ReferencePass, AMeshMustBeAFile) {
  EXPECT_EQ(errors_of("", "{ mesh: nowhere.obj }"),
            Texts{"5:22: bodies.organ.surface.mesh: there is no file `nowhere.obj`"});
  EXPECT_EQ(errors_of("", "{ mesh: / }"), Texts{"5:22: bodies.organ.surface.mesh: `/` is a folder; name a file in it"});
}

TEST(ReferencePass, AShapeHasKnownGroups) {
  EXPECT_EQ(errors_of("    fixed: [ { region: { group: base } } ]\n"),
            Texts{"8:33: bodies.organ.fixed[1].region.group: the shape `sphere` has no group `base`; it has `wall`"});
  EXPECT_EQ(errors_of("    fixed: [ { region: { group: ends } } ]\n", "{ shape: cylinder }"), Texts{});
  EXPECT_EQ(errors_of("    fixed: [ { region: { group: base } } ]\n", "{ shape: hemisphere }"), Texts{});
}

TEST(ReferencePass, AToolThatNoClipUsesIsAWarning) {
  CheckedValue root = checked_scenario("timeline: [ palpate: { tool: probe, depth: 1 mm } ]\n");
  Diagnostics diagnostics;
  reference_pass(root, diagnostics);
  EXPECT_EQ(short_texts(diagnostics.warnings), Texts{"2:34: tools.edge: no clip uses this tool"});
}

TEST(ReferencePass, AFillingOfABodyWithSeveralChambersNamesOne) {
  const auto errors_with = [](const std::string& chambers, const std::string& clip) {
    const std::string text =
        "thinwall: 1\nbodies: { a: { surface: { shape: sphere }, wall: { thickness: 1 mm, material: { law: "
        "neo_hookean, "
        "shear_modulus: 1 kPa } },\n  contents: { chambers: { " +
        chambers + " } } } }\ntimeline: [ " + clip + " ]\n";
    Diagnostics diagnostics;
    CheckedValue root = unit_pass(parse_text(text, diagnostics), scenario_schema(), diagnostics);
    reference_pass(root, diagnostics);
    return short_texts(diagnostics.errors);
  };
  const std::string two = "left: { at: [0, 0, 0] }, right: { at: [1 mm, 0, 0] }";
  EXPECT_EQ(errors_with(two, "inflate: { by: 2 ml }"),
            Texts{"4:13: timeline[1].inflate: `chamber` is missing; there is `left`, `right`"});
  EXPECT_EQ(errors_with(two, "inflate: { by: 2 ml, chamber: right }"), Texts{});
  EXPECT_EQ(errors_with("left: { at: [0, 0, 0] }", "inflate: { by: 2 ml }"), Texts{});
}

TEST(ReferencePass, WhatIsWrongAlreadyIsNotToldAgain) {
  EXPECT_EQ(errors_of("timeline: [ palpate: { tool: [], depth: 1 mm } ]\n"), Texts{});
}

}  // namespace
}  // namespace thinwall
