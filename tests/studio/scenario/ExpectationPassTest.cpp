#include "studio/scenario/ExpectationPass.hpp"

#include <gtest/gtest.h>

#include "tests/studio/scenario/CheckedText.hpp"

namespace thinwall {
namespace {

using Texts = std::vector<std::string>;

Diagnostics diagnostics_of(const std::string& expectation) {
  CheckedValue root = checked_scenario("expect: [ " + expectation + " ]\n");
  Diagnostics diagnostics;
  expectation_pass(root, diagnostics);
  return diagnostics;
}

TEST(ExpectationPass, AChamberIsOneOfTheBodyAndHasPressureAndVolumesOnly) {
  const auto errors_of = [](const std::string& expectation) {
    const std::string text =
        "thinwall: 1\nbodies: { a: { surface: { shape: sphere }, wall: { thickness: 1 mm, material: { law: "
        "neo_hookean, "
        "shear_modulus: 1 kPa } },\n  contents: { chambers: { left: { at: [0, 0, 0] }, right: { at: [1 mm, 0, 0] } } } "
        "} "
        "}\nexpect: [ " +
        expectation + " ]\n";
    Diagnostics diagnostics;
    CheckedValue root = unit_pass(parse_text(text, diagnostics), scenario_schema(), diagnostics);
    expectation_pass(root, diagnostics);
    return short_texts(diagnostics.errors);
  };
  EXPECT_EQ(errors_of("{ quantity: final_pressure, chamber: right, within: [0, 1 kPa] }"), Texts{});
  EXPECT_EQ(errors_of("{ quantity: final_pressure, chamber: rigth, within: [0, 1 kPa] }"),
            Texts{"4:48: expect[1].chamber: there is no chamber `rigth`, did you mean `right`?"});
  EXPECT_EQ(errors_of("{ quantity: final_elastic_energy, chamber: right, within: [0, 1 J] }"),
            Texts{"4:54: expect[1].chamber: `final_elastic_energy` is measured of no chamber; leave it out"});
}

TEST(ExpectationPass, WhatIsWrongBesideAWrongQuantityIsToldWithIt) {
  const auto errors_of = [](const std::string& expectation) { return short_texts(diagnostics_of(expectation).errors); };
  for (const char* quantity : {"quantity: peak_forc, ", ""}) {
    const std::string begin = std::string("{ ") + quantity;
    const auto at = [&](std::size_t column) { return "8:" + std::to_string(column + begin.size()) + ": expect[1]"; };
    EXPECT_EQ(errors_of(begin + "tool: prob, body: orgn, within: [0, 1 N] }"),
              (Texts{at(17) + ".tool: there is no tool `prob`, did you mean `probe`?",
                     at(29) + ".body: there is no body `orgn`, did you mean `organ`?"}));
    EXPECT_EQ(errors_of(begin + "tool: probe, from: 2 s, until: 1 s, within: [0, 1 N] }"),
              Texts{at(42) + ".until: it ends before it begins at 2 s"});
    EXPECT_EQ(errors_of(begin + "tool: probe }"),
              Texts{"8:11: expect[1]: write either `within`, or `value` and `tolerance`"});
    EXPECT_EQ(errors_of(begin + "within: [0, 1 N] }"), Texts{}) << "of which kind its subject is is not known";
  }
}

TEST(ExpectationPass, APartOfTheValueThatIsLargerThanTheValueIsToldOf) {
  const std::string force = "{ quantity: peak_force, tool: probe, value: 0.2 N, tolerance: ";
  EXPECT_EQ(short_texts(diagnostics_of(force + "5 }").warnings),
            Texts{"8:73: expect[1].tolerance: is 5 times `value`, so that its sign does not matter; a part is written "
                  "like `5 %` or 0.05, a difference in the unit of the quantity"});
  EXPECT_EQ(short_texts(diagnostics_of(force + "500 % }").warnings).size(), 1U);
  for (const char* meant : {"5 % }", "0.05 }", "5 N }", "1 }"}) {
    EXPECT_EQ(short_texts(diagnostics_of(force + meant).warnings), Texts{}) << meant;
  }
}

}  // namespace
}  // namespace thinwall
