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

bool asks_for(const Scenario& scenario, const GoldenApproval& approval) {
  return std::ranges::any_of(scenario.goldens, [&](const GoldenDefinition& golden) {
    return golden.video == 0 && std::abs(golden.at - approval.at) <= kSameTime;
  });
}

bool asks_for_video(const Scenario& scenario) {
  return std::ranges::any_of(scenario.goldens, [](const GoldenDefinition& golden) { return golden.video > 0; });
}

void look_at_moments(const Scenario& scenario, const std::filesystem::path& folder, Names& named,
                     std::vector<std::string>& notes) {
  for (const GoldenApproval& approval : read_approvals(folder)) {
    named.insert({"approval.json", approval.image, approval.state, approval.history, approval.second_state});
    if (asks_for(scenario, approval)) continue;
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
  const bool is_meant = asks_for_video(scenario);
  for (const GoldenVideoApproval& approval : read_video_approvals(folder)) {
    named.insert(approval.files.begin(), approval.files.end());
    if (is_meant) continue;
    std::string files;
    for (const std::string& file : approval.files) files += " " + shell_argument((folder / file).string());
    notes.push_back(note(folder / approval.files.back(), "scenario " + scenario.name + " has no golden of its video",
                         "list one under `golden:`, or remove what belongs to it: git rm" + files));
  }
}

/// Whether the scenario asks for all that is approved in a folder, which is something.
bool asks_for_all_of(const Scenario& scenario, const std::filesystem::path& folder) {
  try {
    const std::vector<GoldenApproval> moments = read_approvals(folder);
    const bool has_video = !read_video_approvals(folder).empty();
    return (!moments.empty() || has_video) && (!has_video || asks_for_video(scenario)) &&
           std::ranges::all_of(moments, [&](const GoldenApproval& approval) { return asks_for(scenario, approval); });
  } catch (const GoldenError&) {
    return false;
  }
}

/// For a folder whose scenario is gone: how its approvals are kept where that has another name now; "" where it cannot
/// have one.
std::string cure_for_renaming(const std::filesystem::path& folder, const GoldenOwners& owners) {
  std::string cure;
  for (const Scenario& scenario : owners.scenarios) {
    const std::filesystem::path own = folder.parent_path() / scenario.name;
    if (std::filesystem::exists(own) || !asks_for_all_of(scenario, folder)) continue;
    cure += fmt::format("if it is scenario {} now, keep its approvals: git mv {} {}; ", scenario.name,
                        shell_argument(folder.string()), shell_argument(own.string()));
  }
  return cure;
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

std::vector<std::string> unasked_folders(const std::filesystem::path& root, const GoldenOwners& owners) {
  std::vector<std::string> notes;
  for (const std::filesystem::path& folder : entries_of(root, true)) {
    const std::string name = folder.filename().string();
    if (owners.broken.contains(name) ||
        std::ranges::find(owners.scenarios, name, &Scenario::name) != owners.scenarios.end())
      continue;
    const std::filesystem::path file = owners.scenes / (name + ".yaml");
    const bool is_gone = !std::filesystem::exists(file);
    const std::string keeping = is_gone ? cure_for_renaming(folder, owners) : "";
    notes.push_back(note(folder, file.string() + (is_gone ? " is not there" : " asks for no goldens"),
                         fmt::format("{}{}remove the folder: git rm -r {}", keeping, keeping.empty() ? "" : "else ",
                                     shell_argument(folder.string()))));
  }
  return notes;
}

}  // namespace thinwall
