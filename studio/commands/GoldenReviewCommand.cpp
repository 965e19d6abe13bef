#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "renderer/image/WholeFile.hpp"
#include "studio/commands/Answer.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/GoldenScenarios.hpp"
#include "studio/golden/GoldenReport.hpp"
#include "studio/recorder/FolderLock.hpp"
#include "studio/recorder/Messages.hpp"

namespace thinwall {
namespace {

enum class Answer { kAccept, kReject, kSkip, kQuit };

/// Asks until an answer is one; the end of the input is the wish to end.
Answer ask() {
  for (;;) {
    print_message(stderr, "  [a]ccept, [r]eject, [s]kip or [q]uit? ");
    const std::optional<std::string> line = read_answer();
    if (!line) return Answer::kQuit;
    if (line == "a" || line == "accept") return Answer::kAccept;
    if (line == "r" || line == "reject") return Answer::kReject;
    if (line == "s" || line == "skip") return Answer::kSkip;
    if (line == "q" || line == "quit") return Answer::kQuit;
  }
}

std::string ask_why(const std::string& given) {
  std::string why = given;
  while (why.find_first_not_of(" \t") == std::string::npos) {
    print_message(stderr, "  why is the new picture right? ");
    const std::optional<std::string> line = read_answer();
    if (!line) return "";
    why = *line;
  }
  return why;
}

bool needs_review(const GoldenResult& result) {
  return result.outcome == GoldenOutcome::kFailed || result.outcome == GoldenOutcome::kGoldenMissing;
}

/// What a review has come to.
struct Tally {
  int accepted = 0;
  int rejected = 0;
  int skipped = 0;
  int left = 0;  // not asked for
};

/// What is found in a video stands in a line for each frame.
std::string in_lines(const GoldenResult& result) {
  std::string lines = result.message;
  if (!result.is_video) return lines;
  for (std::size_t at = lines.find("; "); at != std::string::npos; at = lines.find("; ", at))
    lines.replace(at, 2, "\n  ");
  return lines;
}

/// "2 of 5", of those that a person has to judge.
std::string place_of(const Tally& tally, std::size_t all) {
  return fmt::format("{} of {}", tally.accepted + tally.rejected + tally.skipped + 1, all);
}

/// False when the user wants to end.
bool review_one(const JudgedScenario& judged, std::size_t index, const std::string& place, const std::string& why,
                Tally& tally) {
  const GoldenResult& result = judged.results[index];
  const std::string cause = cause_line(judged, index);
  print_message(stderr, "\n{}, {}: {} {}\n", place, outcome_name(result.outcome), result.scenario, moment_name(result));
  if (cause != result.message) print_message(stderr, "  cause: {}\n", cause);
  print_message(stderr, "  {}\n", in_lines(result));
  switch (ask()) {
    case Answer::kAccept: {
      const std::string reason = ask_why(why);
      if (reason.empty()) return false;
      approve_golden(judged, index, reason, false);
      ++tally.accepted;
      return true;
    }
    case Answer::kReject:
      ++tally.rejected;
      return true;
    case Answer::kSkip:
      ++tally.skipped;
      return true;
    case Answer::kQuit:
      break;
  }
  return false;
}

}  // namespace

int review_goldens(const GoldenOptions& options) {
  if (is_continuous_integration()) throw UsageError("golden review: goldens are approved by a person, not in CI");
  const NamedGoldens named = named_goldens(options.scenarios);
  const FolderLock lock(options.out);
  const std::vector<JudgedScenario> all = judge_named(named, options, [](const JudgedScenario& judged) {
    print_message(stderr, "compared: {}\n", judged.scenario.name);
  });
  write_whole_file(options.out / "index.html", golden_report(all, golden_root()));
  print_message(stderr, "look at the pictures: {}\n", (options.out / "index.html").string());
  std::size_t to_judge = 0;
  for (const JudgedScenario& judged : all) to_judge += std::ranges::count_if(judged.results, needs_review);
  Tally tally;
  bool goes_on = true;
  for (const JudgedScenario& judged : all) {
    for (std::size_t i = 0; i < judged.results.size(); ++i) {
      const GoldenResult& result = judged.results[i];
      if (result.outcome == GoldenOutcome::kOk) continue;
      if (!needs_review(result)) {
        print_message(stderr, "{}: {} {}: {}\n", outcome_name(result.outcome), result.scenario, moment_name(result),
                      result.message);
        ++tally.left;
      } else if (goes_on) {
        goes_on = review_one(judged, i, place_of(tally, to_judge), options.why, tally);
        if (!goes_on) ++tally.left;
      } else {
        ++tally.left;
      }
    }
  }
  const int left = tally.skipped + tally.left;
  print_message(stderr, "{} accepted, {} rejected, {} left\n", tally.accepted, tally.rejected, left);
  const auto is_broken = [](const GoldenResult& result) { return result.outcome == GoldenOutcome::kBroken; };
  const bool any_broken = std::ranges::any_of(
      all, [&](const JudgedScenario& judged) { return std::ranges::any_of(judged.results, is_broken); });
  if (any_broken) return kExitBadInput;
  return tally.rejected + left > 0 ? kExitRegression : kExitGood;
}

}  // namespace thinwall
