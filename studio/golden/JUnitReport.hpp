#pragma once

#include <string>
#include <vector>

#include "studio/golden/GoldenRun.hpp"

namespace thinwall {

/// The results as JUnit XML, which build servers show: a suite for each scenario, a case for each golden. What is
/// missing or broken is an error, what differs a failure.
std::string junit_report(const std::vector<JudgedScenario>& scenarios);

/// A line for each golden that is not ok in the form in which GitHub puts notes beside a pull request.
std::string github_annotations(const std::vector<JudgedScenario>& scenarios);

}  // namespace thinwall
