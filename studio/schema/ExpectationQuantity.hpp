#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "studio/record/StepRecord.hpp"
#include "studio/schema/Quantity.hpp"

namespace thinwall {

/// What a quantity belongs to: the key of `expect` that names it.
enum class ExpectationSubject { kTool, kBody, kPoint };

/// A number of each step that a scenario may expect something of.
struct MeasuredQuantity {
  std::string_view name;
  ExpectationSubject subject;
  Dimension dimension;
  double (*of_tool)(const ToolRecord&);  // SI; the one of the subject is set
  double (*of_body)(const BodyRecord&);
  double (*of_point)(const PointRecord&);
  std::string_view documentation;
  bool is_of_chambers = false;  // a body's quantity that its chambers have each for itself
};

/// What is made of the numbers of many steps.
enum class Reduction { kMoment, kPeak, kLowest, kMean, kFinal };

struct ReductionWord {
  std::string_view prefix;  // "peak_"; "" of a moment
  Reduction reduction;
  std::string_view documentation;
};

/// A word of `expect`: `peak_force`.
struct ExpectationQuantity {
  const MeasuredQuantity* measured = nullptr;
  Reduction reduction = Reduction::kMoment;
};

std::span<const MeasuredQuantity> measured_quantities();
std::span<const ReductionWord> reduction_words();

/// All words, each quantity with each prefix.
std::vector<std::string> expectation_words();

/// The quantity of a word; without `measured` when there is none.
ExpectationQuantity find_expectation_quantity(std::string_view word);

/// "tool", "body", "point"
std::string_view subject_word(ExpectationSubject subject);

}  // namespace thinwall
