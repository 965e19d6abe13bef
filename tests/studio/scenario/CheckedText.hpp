#pragma once

#include <string>

#include "studio/scenario/UnitPass.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"

namespace thinwall {

/// A scenario with a body `organ` of the given surface and a tool `probe`, and further sections, read but not checked
/// for references and lints. The sections begin in line 8.
inline CheckedValue checked_scenario(const std::string& sections, const std::string& surface = "{ shape: sphere }") {
  const std::string text =
      "thinwall: 1\n"
      "tools: { probe: { kind: point }, edge: { kind: line } }\n"
      "bodies:\n"
      "  organ:\n"
      "    surface: " +
      surface +
      "\n"
      "    wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 1 kPa } }\n"
      "    contents: { fluid: none }\n" +
      sections;
  Diagnostics ignored;
  return unit_pass(parse_text(text, ignored), scenario_schema(), ignored);
}

}  // namespace thinwall
