#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "renderer/image/Folder.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/GoldenAnswers.hpp"
#include "studio/commands/GoldenScenarios.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/golden/GoldenReport.hpp"
#include "studio/golden/JUnitReport.hpp"
#include "studio/golden/PicturesForLooking.hpp"
#include "studio/recorder/FolderLock.hpp"
#include "studio/recorder/Messages.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

int exit_code(const std::vector<JudgedScenario>& all) {
  int code = kExitGood;
  for (const JudgedScenario& judged : all) {
    for (const GoldenResult& result : judged.results) code = worse_exit_code(code, exit_code(result));
  }
  return code;
}

std::map<GoldenOutcome, int> counts(const std::vector<JudgedScenario>& all) {
  std::map<GoldenOutcome, int> counts;
  for (const auto outcome : {GoldenOutcome::kOk, GoldenOutcome::kFailed, GoldenOutcome::kResultMissing,
                             GoldenOutcome::kGoldenMissing, GoldenOutcome::kSkipped, GoldenOutcome::kBroken}) {
    counts[outcome] = 0;
  }
  for (const JudgedScenario& judged : all) {
    for (const GoldenResult& result : judged.results) ++counts[result.outcome];
  }
  return counts;
}

void print_summary(const std::vector<JudgedScenario>& all, const std::vector<std::string>& notes, int code, bool json) {
  std::string line;
  Json json_counts = Json::object();
  for (const auto& [outcome, count] : counts(all)) {
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count, outcome_name(outcome));
    json_counts[outcome_name(outcome)] = count;
  }
  for (const std::string& note : notes) print_message(stderr, "{}\n", note);
  for (const std::string& closing : closing_lines(all)) print_message(stderr, "{}\n", closing);
  print_message(stderr, "{}\n", line);
  if (!json) return;
  Json list = Json::array();
  for (const JudgedScenario& judged : all) {
    for (std::size_t i = 0; i < judged.results.size(); ++i) list.push_back(golden_as_json(judged, i));
  }
  print_json({{"goldens", list}, {"counts", json_counts}, {"notes", notes}, {"exit_code", code}});
}

/// What could not be written, a message each: what is compared is told all the same.
class Unwritten {
 public:
  template <typename Write>
  void attempt(Write&& write) {
    try {
      write();
    } catch (const PictureFailure& failure) {
      messages_.emplace_back(failure.what());
    }
  }
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

std::vector<JudgedScenario> judge_and_print(const NamedGoldens& named, const GoldenOptions& options,
                                            Unwritten& unwritten) {
  const auto print = [&](const JudgedScenario& judged) {
    PicturesForLooking pictures(options.out / judged.scenario.name);
    for (std::size_t i = 0; i < judged.results.size(); ++i) {
      print_result(judged, i);
      unwritten.attempt([&] {
        for (const std::string& line : pictures.keep(judged, i, golden_folder(judged.scenario.name))) {
          print_message(stderr, "  {}\n", line);
        }
      });
    }
    pictures.remove_others();
  };
  return judge_named(named, options, print);
}

std::filesystem::path report_page(const GoldenOptions& options) {
  return options.out / "index.html";
}

void write_report(const std::vector<JudgedScenario>& all, const GoldenOptions& options) {
  const std::filesystem::path page = report_page(options);
  write_whole_file(page, golden_report(all, golden_root()));
  print_message(stderr, "report: {}\n", page.string());
}

/// Before the comparison, so that what cannot be written is told at once.
void prepare_junit(const std::filesystem::path& file) {
  if (file.has_parent_path()) make_folder(file.parent_path());
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw UsageError("golden: --junit " + file.string() + " is a folder; name a file");
  }
  if (!error || error == std::errc::no_such_file_or_directory) return;
  throw PictureFailure("cannot write " + file.string() + ": " + error.message() + "; " +
                       cure_for_write_error(error.value()));
}

/// When the page to look at is written.
enum class PageOf { kFailures, kAll };

int compare_goldens(const GoldenOptions& options, PageOf page) {
  const NamedGoldens named = named_goldens(options.scenarios);
  const FolderLock lock(options.out);
  if (!options.junit.empty()) prepare_junit(options.junit);
  Unwritten unwritten;
  const std::vector<JudgedScenario> all = judge_and_print(named, options, unwritten);
  const bool are_good = exit_code(all) == kExitGood;
  if (!options.junit.empty()) unwritten.attempt([&] { write_whole_file(options.junit, junit_report(all)); });
  if (std::getenv("GITHUB_ACTIONS") != nullptr) print_message(stderr, "{}", github_annotations(all));
  if (!are_good || page == PageOf::kAll) {
    unwritten.attempt([&] { write_report(all, options); });
  } else {
    std::error_code ignored;
    std::filesystem::remove(report_page(options), ignored);  // of an earlier test, in which something had failed
  }
  std::vector<std::string> notes = golden_notes(named);
  std::ranges::copy(unwritten.messages(), std::back_inserter(notes));
  const int code = unwritten.messages().empty() ? exit_code(all) : worse_exit_code(exit_code(all), kExitNoPicture);
  print_summary(all, notes, code, options.json);
  return code;
}

}  // namespace

int test_goldens(const GoldenOptions& options) {
  return compare_goldens(options, PageOf::kFailures);
}

int report_goldens(const GoldenOptions& options) {
  return compare_goldens(options, PageOf::kAll);
}

}  // namespace thinwall
