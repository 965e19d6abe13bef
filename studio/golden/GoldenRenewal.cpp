#include "studio/golden/GoldenRenewal.hpp"

#include <algorithm>
#include <cstdlib>

#include "renderer/image/Folder.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/picture/PictureFailure.hpp"
#include "renderer/video/Program.hpp"
#include "studio/golden/OverlayRecord.hpp"
#include "studio/take/TakeWriter.hpp"

namespace thinwall {

void renew_golden(const Scenario& scenario, const GoldenPicture& picture, const std::string& driver,
                  const std::filesystem::path& folder, const std::string& who, const std::string& why) {
  make_folder(folder);
  std::vector<GoldenApproval> approvals = read_approvals(folder);
  const std::string stem = golden_stem(picture.at, driver);
  const GoldenApproval renewed{.at = picture.at,
                               .driver = driver,
                               .image = stem + ".png",
                               .state = stem + ".state.h5",
                               .state_digest = picture.state_digest,
                               .who = who,
                               .why = why,
                               .history = stem + ".history.csv",
                               .scene_hash = picture.scene_hash,
                               .overlay = overlay_record(picture.overlay)};
  {
    TakeWriter state(folder / renewed.state,
                     {.name = scenario.name, .title = scenario.title, .resolved = scenario.resolved});
    state.write(picture.moment);
    state.finish({.complete = false, .warnings = {}, .state_digest = picture.state_digest});
  }
  write_whole_file(folder / renewed.history, history_text(picture.history));
  write_png(folder / renewed.image, picture.image, PngEffort::kSmall);
  const GoldenApproval* before = find_approval(approvals, picture.at, driver);
  if (before != nullptr && before->driver == driver) {
    approvals[static_cast<std::size_t>(before - approvals.data())] = renewed;
  } else {
    approvals.push_back(renewed);
  }
  std::stable_sort(approvals.begin(), approvals.end(),
                   [](const GoldenApproval& a, const GoldenApproval& b) { return a.at < b.at; });
  write_approvals(folder, approvals);
}

std::string approver() {
  try {
    const ProgramResult git = run_program({"git", "config", "user.name"});
    const std::string name = git.output.substr(0, git.output.find('\n'));
    if (git.exit_code == 0 && !name.empty()) return name;
  } catch (const PictureFailure&) {
    // There is no git here.
  }
  const char* login = std::getenv("USER");
  return login != nullptr && *login != '\0' ? login : "unknown";
}

}  // namespace thinwall
