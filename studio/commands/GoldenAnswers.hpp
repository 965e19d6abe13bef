#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "studio/golden/GoldenRun.hpp"

namespace thinwall {

// What the golden commands say of a golden that has been judged.

/// Outcome, cause and details on standard error.
void print_result(const JudgedScenario& judged, std::size_t index);

/// What is not as it should be, a line for each outcome, and how it is approved; nothing where all is. Between the
/// results of many goldens the few that failed are lost.
std::vector<std::string> closing_lines(const std::vector<JudgedScenario>& all);

/// What print_result says and all figures, as an object.
nlohmann::ordered_json golden_as_json(const JudgedScenario& judged, std::size_t index);

/// What one golden gives. Nothing was compared where it is skipped, which is no success.
int exit_code(const GoldenResult& result);

/// Of two goldens': what is to be mended first. A regression is one, whatever else could not be made.
int worse_exit_code(int first, int second);

}  // namespace thinwall
