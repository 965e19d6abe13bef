#include "studio/expectation/ExpectationCheck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "renderer/snapshot/SameTime.hpp"
#include "studio/schema/ExpectationQuantity.hpp"

namespace thinwall {
namespace {

/// What a body would be that had this chamber alone.
BodyRecord as_body(const ChamberRecord& chamber) {
  BodyRecord body;
  body.volume = chamber.volume;
  body.fluid_volume = chamber.fluid_volume;
  body.pressure = chamber.pressure;
  return body;
}

double measure(const Expectation& expectation, const MeasuredQuantity& quantity, const StepRecord& record) {
  for (const ChamberRecord& chamber : record.chambers) {
    const bool is_meant = chamber.body == expectation.subject && chamber.chamber == expectation.chamber;
    if (is_meant && quantity.is_of_chambers) return quantity.of_body(as_body(chamber));
  }
  for (const ToolRecord& tool : record.tools) {
    if (quantity.of_tool != nullptr && tool.tool == expectation.subject) return quantity.of_tool(tool);
  }
  for (const BodyRecord& body : record.bodies) {
    if (quantity.of_body != nullptr && body.body == expectation.subject) return quantity.of_body(body);
  }
  for (const PointRecord& point : record.points) {
    if (quantity.of_point != nullptr && point.point == expectation.subject) return quantity.of_point(point);
  }
  assert(false);
  return 0;
}

struct Sample {
  double time = 0;   // seconds
  double value = 0;  // SI
};

/// A quantity as a curve of straight pieces.
class Curve {
 public:
  Curve(const std::vector<double>& times, const std::vector<double>& values) : times_(times), values_(values) {}

  std::optional<double> at(double time) const {
    if (times_.empty() || time < times_.front() - kSameTime || time > times_.back() + kSameTime) return std::nullopt;
    const auto later = std::ranges::lower_bound(times_, time - kSameTime);
    const auto index = static_cast<std::size_t>(later - times_.begin());
    if (index == 0 || *later <= time + kSameTime) return values_[index];
    const double part = (time - times_[index - 1]) / (times_[index] - times_[index - 1]);
    return values_[index - 1] + part * (values_[index] - values_[index - 1]);
  }

  /// The corners of the curve between two times, with its ends; none when it does not reach the second.
  std::vector<Sample> between(double from, double until) const {
    const std::optional<double> first = at(from);
    const std::optional<double> last = at(until);
    if (!first || !last) return {};
    std::vector<Sample> samples = {{from, *first}};
    for (std::size_t step = 0; step < times_.size(); ++step) {
      if (times_[step] > from + kSameTime && times_[step] < until - kSameTime) {
        samples.push_back({times_[step], values_[step]});
      }
    }
    samples.push_back({until, *last});
    return samples;
  }

 private:
  const std::vector<double>& times_;
  const std::vector<double>& values_;
};

double mean(const std::vector<Sample>& samples) {
  const double duration = samples.back().time - samples.front().time;
  if (duration <= 0) return samples.front().value;
  double sum = 0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    sum += (samples[k].time - samples[k - 1].time) * (samples[k].value + samples[k - 1].value) / 2;
  }
  return sum / duration;
}

std::optional<double> reduce(const Expectation& expectation, Reduction reduction, const std::vector<double>& times,
                             const std::vector<double>& values) {
  if (times.empty()) return std::nullopt;
  const Curve curve(times, values);
  if (reduction == Reduction::kMoment) return curve.at(*expectation.at);
  if (reduction == Reduction::kFinal) return values.back();
  const auto samples =
      curve.between(expectation.from.value_or(times.front()), expectation.until.value_or(times.back()));
  if (samples.empty()) return std::nullopt;
  if (reduction == Reduction::kMean) return mean(samples);
  const auto [lowest, highest] = std::ranges::minmax(samples, {}, &Sample::value);
  return reduction == Reduction::kPeak ? highest.value : lowest.value;
}

}  // namespace

ExpectationCheck::ExpectationCheck(std::vector<Expectation> expectations)
    : expectations_(std::move(expectations)), values_(expectations_.size()) {}

void ExpectationCheck::add(const StepRecord& record) {
  if (expectations_.empty()) return;
  times_.push_back(record.time);
  for (std::size_t k = 0; k < expectations_.size(); ++k) {
    const ExpectationQuantity quantity = find_expectation_quantity(expectations_[k].quantity);
    values_[k].push_back(measure(expectations_[k], *quantity.measured, record));
  }
}

std::vector<ExpectationResult> ExpectationCheck::results() const {
  std::vector<ExpectationResult> results;
  for (std::size_t k = 0; k < expectations_.size(); ++k) {
    const Expectation& expectation = expectations_[k];
    const Reduction reduction = find_expectation_quantity(expectation.quantity).reduction;
    const std::optional<double> value = reduce(expectation, reduction, times_, values_[k]);
    const bool passed = value && *value >= expectation.lowest && *value <= expectation.highest;
    results.push_back({.expectation = expectation, .value = value, .passed = passed});
  }
  return results;
}

std::string to_text(const ExpectationResult& result) {
  const Expectation& expectation = result.expectation;
  const MeasuredQuantity& measured = *find_expectation_quantity(expectation.quantity).measured;
  // In the unit that the dimension is written with in messages: millilitres are read, 7.2e-05 m^3 is not.
  const auto words = [&](double value) { return format_like(value, dimension_example(measured.dimension)); };
  const std::string value = result.value ? "is " + words(*result.value) : "was not reached";
  const std::string chamber = expectation.chamber.empty() ? "" : "chamber `" + expectation.chamber + "` of ";
  return fmt::format("{}: {} of {}{} `{}` {}, expected from {} to {}", result.passed ? "met" : "FAILED",
                     expectation.quantity, chamber, subject_word(measured.subject), expectation.subject, value,
                     words(expectation.lowest), words(expectation.highest));
}

}  // namespace thinwall
