#pragma once

#include <string>
#include <vector>

#include "studio/record/StepRecord.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// What became of an expectation.
struct ExpectationResult {
  Expectation expectation;
  std::optional<double> value;  // SI; empty when the run did not reach its time
  bool passed = false;
};

/// Follows a run and says at its end which expectations it met. Between two steps a quantity lies on the straight line
/// between its values at them; so averages are trapezoids, and peaks are at steps or at the ends of the span of time.
class ExpectationCheck {
 public:
  explicit ExpectationCheck(std::vector<Expectation> expectations);

  /// The records in order of time.
  void add(const StepRecord& record);

  /// In the order of the scenario.
  std::vector<ExpectationResult> results() const;

 private:
  std::vector<Expectation> expectations_;
  std::vector<double> times_;                // (steps), seconds
  std::vector<std::vector<double>> values_;  // (expectations x steps), SI
};

/// "met: peak_force of tool `probe` is 0.31 N, expected from 0.2 N to 0.4 N", or "FAILED: ...".
std::string to_text(const ExpectationResult& result);

}  // namespace thinwall
