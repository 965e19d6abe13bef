#include "studio/golden/GoldenRenewal.hpp"

#include <algorithm>
#include <cstdlib>

#include "renderer/image/Folder.hpp"
#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/video/Program.hpp"
#include "studio/golden/NamedFiles.hpp"
#include "studio/golden/OverlayRecord.hpp"
#include "studio/take/TakeWriter.hpp"

namespace thinwall {
namespace {

/// The moment as a take of one step.
void write_state(const std::filesystem::path& file, const Scenario& scenario, const Moment& moment,
                 const std::string& digest) {
  try {
    TakeWriter state(file, {.name = scenario.name, .title = scenario.title, .resolved = scenario.resolved});
    state.write(moment);
    state.finish({.complete = false, .warnings = {}, .state_digest = digest});
  } catch (...) {
    // Of a run it would be of use; among goldens it would get under version control.
    std::error_code ignored;
    std::filesystem::remove(unfinished_name(file), ignored);
    throw;
  }
}

std::vector<std::string> set_aside_in(const Snapshot& snapshot) {
  std::vector<std::string> names;
  for (const SnapshotTool& tool : snapshot.tools) {
    if (tool.is_set_aside) names.push_back(tool.name);
  }
  return names;
}

/// What the approval before had under names of its own, as earlier versions gave them.
void remove_files_but(const GoldenApproval& replaced, const GoldenApproval& renewed,
                      const std::filesystem::path& folder) {
  for (const auto file :
       {&GoldenApproval::image, &GoldenApproval::state, &GoldenApproval::second_state, &GoldenApproval::history}) {
    std::error_code ignored;
    if (!(replaced.*file).empty() && replaced.*file != renewed.*file) {
      std::filesystem::remove(folder / replaced.*file, ignored);
    }
  }
}

}  // namespace

void renew_golden(const Scenario& scenario, const GoldenPicture& picture, const std::string& driver,
                  const std::filesystem::path& folder, const std::string& who, const std::string& why) {
  make_folder(folder);
  std::vector<GoldenApproval> approvals = read_approvals(folder);
  const std::string stem = golden_stem(picture.at, driver);
  std::optional<std::vector<std::string>> second_set_aside;
  if (picture.moment.second) second_set_aside = set_aside_in(picture.moment.second->snapshot);
  const GoldenApproval renewed{.at = picture.at,
                               .driver = driver,
                               .image = stem + ".png",
                               .state = stem + ".state.h5",
                               .state_digest = picture.state_digest,
                               .who = who,
                               .why = why,
                               .history = stem + ".history.csv",
                               .scene_hash = picture.scene_hash,
                               .overlay = overlay_record(picture.overlay),
                               .second_state = picture.moment.second ? stem + ".second_state.h5" : "",
                               .second_state_digest = picture.second_state_digest,
                               .picture_hash = image_hash(picture.image),
                               .files = named_files_record(scenario),
                               .set_aside = set_aside_in(picture.moment.snapshot),
                               .second_set_aside = second_set_aside};
  write_state(folder / renewed.state, scenario, picture.moment, picture.state_digest);
  if (picture.moment.second) {
    write_state(folder / renewed.second_state, *scenario.comparison->second, *picture.moment.second,
                picture.second_state_digest);
  }
  write_whole_file(folder / renewed.history, history_text(picture.history));
  write_png(folder / renewed.image, picture.image, PngEffort::kSmall);
  const GoldenApproval* before = find_approval(approvals, picture.at, driver);
  const bool is_replaced = before != nullptr && before->driver == driver;
  const GoldenApproval replaced = is_replaced ? *before : GoldenApproval{};
  if (is_replaced) {
    approvals[static_cast<std::size_t>(before - approvals.data())] = renewed;
  } else {
    approvals.push_back(renewed);
  }
  std::stable_sort(approvals.begin(), approvals.end(),
                   [](const GoldenApproval& a, const GoldenApproval& b) { return a.at < b.at; });
  write_approvals(folder, approvals);
  remove_files_but(replaced, renewed, folder);
}

std::string approver() {
  try {
    const ProgramResult git = run_program({"git", "config", "user.name"});
    std::string name = git.output.substr(0, git.output.find('\n'));
    if (git.exit_code == 0 && !name.empty()) return name;
  } catch (const PictureFailure&) {
    // There is no git here.
  }
  const char* login = std::getenv("USER");
  return login != nullptr && *login != '\0' ? login : "unknown";
}

}  // namespace thinwall
