#include "studio/golden/PicturesForLooking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <system_error>

#include "renderer/image/Folder.hpp"
#include "renderer/image/PngFile.hpp"

namespace thinwall {
namespace {

constexpr const char* kToday = ".today.png";
constexpr const char* kGoldenState = ".golden_state.png";
constexpr const char* kGoldenLook = ".golden_look.png";
constexpr const char* kDifference = ".difference.png";

/// Whether a test writes pictures of this name.
bool is_for_looking(const std::string& name) {
  constexpr const char* kKinds[] = {kToday, kGoldenState, kGoldenLook, kDifference};
  return name.starts_with("at_") && std::ranges::any_of(kKinds, [&](const char* kind) { return name.ends_with(kind); });
}

}  // namespace

void PicturesForLooking::write(std::vector<std::string>& lines, const std::string& words, const std::string& name,
                               const Image& image) {
  const std::filesystem::path file = folder_ / name;
  write_png(file, image);
  written_.insert(name);
  lines.push_back(words + ": " + file.string());
}

std::vector<std::string> PicturesForLooking::keep(const JudgedScenario& judged, std::size_t index,
                                                  const std::filesystem::path& goldens) {
  const GoldenResult& result = judged.results[index];
  if (result.outcome != GoldenOutcome::kFailed && result.outcome != GoldenOutcome::kGoldenMissing) return {};
  if (result.is_video) {
    return judged.video->file.empty() ? std::vector<std::string>{}
                                      : std::vector{"today's video: " + judged.video->file.string()};
  }
  std::vector<std::string> lines;
  const Image& today = judged.pictures.pictures[index].image;
  make_folder(folder_);
  const std::string stem = fmt::format("at_{:.9g}s", result.at);
  write(lines, "today's picture", stem + kToday, today);
  const std::optional<Attribution>& attribution = judged.attributions[index];
  if (attribution && attribution->golden_state) {
    write(lines, "the golden's state, drawn today", stem + kGoldenState, *attribution->golden_state);
  }
  if (attribution && attribution->golden_look) {
    write(lines, "today's state in the golden's look", stem + kGoldenLook, *attribution->golden_look);
  }
  if (result.outcome != GoldenOutcome::kFailed || result.difference.verdict != ImageVerdict::kDifferent) return lines;
  const std::vector<GoldenApproval> approvals = read_approvals(goldens);
  const Image golden = read_png(goldens / find_approval(approvals, result.at, result.driver)->image);
  write(lines, "difference", stem + kDifference, difference_picture(golden, today));
  return lines;
}

void PicturesForLooking::remove_others() const {
  std::error_code ignored;
  std::vector<std::filesystem::path> outdated;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored)) {
    const std::string name = entry.path().filename().string();
    if (is_for_looking(name) && !written_.contains(name)) outdated.push_back(entry.path());
  }
  for (const std::filesystem::path& file : outdated) std::filesystem::remove(file, ignored);
  // One that is not empty stays.
  std::filesystem::remove(folder_, ignored);
}

}  // namespace thinwall
