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
  EXPECT_EQ(short_texts(diagnostics.errors), Texts{});
  return diagnostics;
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
