#include "studio/golden/UnaskedGoldens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/snapshot/SameTime.hpp"
#include "studio/golden/GoldenApproval.hpp"
#include "studio/golden/GoldenVideoApproval.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

using Names = std::set<std::string>;

std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder, bool folders) {
  std::vector<std::filesystem::path> entries;
  if (!std::filesystem::is_directory(folder)) return entries;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const bool is_hidden = entry.path().filename().string().starts_with(".");
    if (!is_hidden && entry.is_directory() == folders) entries.push_back(entry.path());
  }
  std::ranges::sort(entries);
  return entries;
}

std::string note(const std::filesystem::path& path, const std::string& why, const std::string& cure) {
  return fmt::format("{}: note: {}, so nothing is compared with it; {}", path.string(), why, cure);
}

/// A person may have left a page of words beside the goldens.
bool is_of_a_golden(const std::filesystem::path& file) {
  constexpr const char* kExtensions[] = {".png", ".h5", ".csv", ".json"};
  return std::ranges::find(kExtensions, file.extension()) != std::end(kExtensions);
}

void look_at_moments(const Scenario& scenario, const std::filesystem::path& folder, Names& named,
                     std::vector<std::string>& notes) {
  for (const GoldenApproval& approval : read_approvals(folder)) {
    named.insert({"approval.json", approval.image, approval.state, approval.history, approval.second_state});
    const auto is_meant = [&](const GoldenDefinition& golden) {
      return golden.video == 0 && std::abs(golden.at - approval.at) <= kSameTime;
    };
    if (std::ranges::any_of(scenario.goldens, is_meant)) continue;
    const std::string stem = std::filesystem::path(approval.image).stem().string();
    notes.push_back(note(folder / approval.image,
                         fmt::format("no golden of scenario {} is at {:.9g} s", scenario.name, approval.at),
                         fmt::format("list that time under `golden:`, or remove {}.* (git rm) and its entry in "
                                     "approval.json",
                                     stem)));
  }
}

void look_at_videos(const Scenario& scenario, const std::filesystem::path& folder, Names& named,
                    std::vector<std::string>& notes) {
  const bool is_meant = std::ranges::any_of(scenario.goldens, [](const auto& golden) { return golden.video > 0; });
  for (const GoldenVideoApproval& approval : read_video_approvals(folder)) {
    named.insert(approval.files.begin(), approval.files.end());
    if (is_meant) continue;
    std::string files;
    for (const std::string& file : approval.files) files += " " + shell_argument((folder / file).string());
    notes.push_back(note(folder / approval.files.back(), "scenario " + scenario.name + " has no golden of its video",
                         "list one under `golden:`, or remove what belongs to it: git rm" + files));
  }
}

}  // namespace

std::vector<std::string> unasked_goldens(const Scenario& scenario, const std::filesystem::path& folder) {
  std::vector<std::string> notes;
  Names named;
  try {
    look_at_moments(scenario, folder, named, notes);
    look_at_videos(scenario, folder, named, notes);
  } catch (const GoldenError&) {
    return {};
  }
  for (const std::filesystem::path& file : entries_of(folder, false)) {
    if (!is_of_a_golden(file) || named.contains(file.filename().string())) continue;
    notes.push_back(note(file, "no approval names it", "remove it: git rm " + shell_argument(file.string())));
  }
  return notes;
}

std::vector<std::string> unasked_folders(const std::filesystem::path& root, const Names& scenarios) {
  std::vector<std::string> notes;
  for (const std::filesystem::path& folder : entries_of(root, true)) {
    const std::string name = folder.filename().string();
    if (scenarios.contains(name)) continue;
    notes.push_back(note(folder, "scenes/" + name + ".yaml has no goldens or is not there",
                         "remove the folder: git rm -r " + shell_argument(folder.string())));
  }
  return notes;
}

}  // namespace thinwall
