#include "studio/golden/JUnitReport.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace thinwall {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        // XML has no other control characters than these.
        result += static_cast<unsigned char>(letter) < 0x20 && letter != '\n' && letter != '\t' ? ' ' : letter;
    }
  }
  return result;
}

std::string case_name(const GoldenResult& result) {
  if (result.is_scenario) return "scenario";
  return result.is_video ? "video" : fmt::format("{:.9g} s", result.at);
}

std::string case_of(const JudgedScenario& judged, std::size_t index) {
  const GoldenResult& result = judged.results[index];
  std::string text =
      fmt::format("    <testcase classname=\"golden.{}\" name=\"{}\"", escaped(result.scenario), case_name(result));
  if (result.outcome == GoldenOutcome::kOk) return text + "/>\n";
  if (result.outcome == GoldenOutcome::kSkipped) {
    return text + fmt::format(">\n      <skipped message=\"{}\"/>\n    </testcase>\n", escaped(result.message));
  }
  const char* element = result.outcome == GoldenOutcome::kFailed ? "failure" : "error";
  return text + fmt::format(">\n      <{0} type=\"{1}\" message=\"{2}\">{3}\n{4}</{0}>\n    </testcase>\n", element,
                            outcome_name(result.outcome), escaped(cause_line(judged, index)), escaped(result.message),
                            escaped(result.details));
}

/// GitHub's own escapes of line ends and percent signs.
std::string for_github(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '%') {
      result += "%25";
    } else if (letter == '\n') {
      result += "%0A";
    } else {
      result += letter;
    }
  }
  return result;
}

}  // namespace

std::string junit_report(const std::vector<JudgedScenario>& scenarios) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"golden images\">\n";
  for (const JudgedScenario& judged : scenarios) {
    const auto count = [&](auto... outcomes) {
      return std::count_if(judged.results.begin(), judged.results.end(),
                           [&](const GoldenResult& result) { return ((result.outcome == outcomes) || ...); });
    };
    text += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n",
                        escaped(judged.scenario.name), judged.results.size(), count(GoldenOutcome::kFailed),
                        count(GoldenOutcome::kResultMissing, GoldenOutcome::kGoldenMissing, GoldenOutcome::kBroken),
                        count(GoldenOutcome::kSkipped));
    for (std::size_t i = 0; i < judged.results.size(); ++i) text += case_of(judged, i);
    text += "  </testsuite>\n";
  }
  return text + "</testsuites>\n";
}

std::string github_annotations(const std::vector<JudgedScenario>& scenarios) {
  std::string text;
  for (const JudgedScenario& judged : scenarios) {
    for (std::size_t i = 0; i < judged.results.size(); ++i) {
      const GoldenResult& result = judged.results[i];
      if (result.outcome == GoldenOutcome::kOk) continue;
      const SourceLocation& location = judged.scenario.goldens[i].location;
      text += fmt::format("::{} file={},line={},title={} {}: {}::{}\n",
                          result.outcome == GoldenOutcome::kSkipped ? "warning" : "error",
                          judged.scenario.file.lexically_normal().generic_string(), location.line, result.scenario,
                          moment_name(result), outcome_name(result.outcome), for_github(cause_line(judged, i)));
    }
  }
  return text;
}

}  // namespace thinwall
