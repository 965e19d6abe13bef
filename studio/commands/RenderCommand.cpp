#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "renderer/snapshot/SurfaceFields.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/DataViewRange.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/Outcome.hpp"
#include "studio/commands/SecondTake.hpp"
#include "studio/director/StressFreeAnswers.hpp"
#include "studio/recorder/FolderLock.hpp"
#include "studio/recorder/RecordingNotes.hpp"
#include "studio/recorder/ResolvedPicture.hpp"
#include "studio/scenario/LoadScenario.hpp"
#include "studio/take/TakeError.hpp"
#include "studio/take/TakeReader.hpp"

namespace thinwall {
namespace {

void refuse_folder_of_the_take(const std::filesystem::path& folder, const std::filesystem::path& take) {
  std::error_code none;
  if (std::filesystem::equivalent(folder, take.parent_path().empty() ? "." : take.parent_path(), none)) {
    throw UsageError("--out " + folder.string() +
                     ": the take lies here, and its recording would be overwritten; choose another folder");
  }
}

void require_stress(const Snapshot& snapshot, const std::filesystem::path& take) {
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    if (!von_mises_stress(surface).empty()) continue;
    throw TakeError(take.string() +
                    ": the take holds no stress, which --aov tells: an older version of this program made it; run the "
                    "scenario again");
  }
}

/// What is to be told of takes whose runs failed or were stopped before their end.
std::vector<std::string> early_ends(const std::vector<std::filesystem::path>& takes) {
  std::vector<std::string> told;
  for (const std::filesystem::path& file : takes) {
    const TakeReader take(file);
    if (take.ending().complete) continue;
    told.push_back(
        fmt::format("the take {} ends early, {}: its run failed or was stopped; run the scenario again", file.string(),
                    take.times().empty() ? "without any step" : fmt::format("at {:.4g} s", take.times().back())));
  }
  return told;
}

/// What a take is drawn with: as it was recorded, or as another scenario looks at it.
struct DrawnAs {
  PictureSettings settings;
  std::optional<ViewDefinition> second_view;  // of the take that this one is compared with
};

/// Of a take without any step nothing is shown.
void require_followed_tools(const ViewDefinition& view, const TakeReader& take, const std::filesystem::path& scenario) {
  if (take.times().empty()) return;
  std::vector<std::string> names;
  for (const SnapshotTool& tool : take.moment(0).snapshot.tools) names.push_back(tool.name);
  const auto require = [&](const std::string& camera, const CameraDefinition& definition) {
    if (!definition.follow || std::ranges::find(names, definition.follow->tool) != names.end()) return;
    throw UsageError(fmt::format("--view {}: {} follows tool `{}`, which the take does not have; {}", scenario.string(),
                                 camera, definition.follow->tool,
                                 names.empty() ? "it has none" : fmt::format("its tools: {}", fmt::join(names, ", "))));
  };
  require("`camera`", view.camera);
  for (const auto& [name, camera] : view.cameras) require("camera `" + name + "`", camera);
}

/// A view may be of a scenario with other tools.
void require_followed_tools(const DrawnAs& drawn, const TakeReader& take,
                            const std::vector<std::filesystem::path>& takes, const std::filesystem::path& scenario) {
  require_followed_tools(drawn.settings.view, take, scenario);
  if (takes.size() > 1) require_followed_tools(*drawn.second_view, TakeReader(takes.back()), scenario);
}

DrawnAs drawn_as(const RenderOptions& options, const TakeReader& take) {
  DrawnAs drawn{.settings = picture_settings(take.description().resolved), .second_view = {}};
  if (!options.view) return drawn;
  const Scenario view = load_scenario(*options.view, options.overrides, stress_free_answers());
  const Teaching taught = drawn.settings.teaching;
  drawn.settings = picture_settings(view);
  drawn.settings.teaching = taught;
  drawn.second_view = view.comparison ? picture_settings(*view.comparison->second).view : drawn.settings.view;
  return drawn;
}

}  // namespace

int render_take(const RenderOptions& options) {
  StageTime preparation;
  std::optional<TakeReader> take;
  DrawnAs drawn;
  {
    const StageClock clock(preparation);
    take.emplace(options.take);
    drawn = drawn_as(options, *take);
  }
  PictureSettings& settings = drawn.settings;
  if (take->times().empty())
    throw TakeError(options.take.string() + ": the take holds no step, so there is nothing to draw");
  if (options.data) settings.view.look.data = DataView{.quantity = *options.data};
  change_data_view(options.data_changes, settings.view.look);
  if (options.mesh) settings.view.look.mesh = true;
  const std::vector<std::filesystem::path> takes = takes_shown(options.take);
  if (options.view) require_followed_tools(drawn, *take, takes, *options.view);
  complete_data_range(takes, settings.view.look);
  const DataViewChanges& changes = options.data_changes;
  const CommonLook common{.data = options.data || changes.from || changes.to || changes.scale, .mesh = options.mesh};
  const std::unique_ptr<MomentSource> source = replay_takes(takes, common, settings.view, drawn.second_view);
  if (options.ground_truth) prepare_truth(settings.view);
  const RecordingPlan plan{.folder = options.out.value_or(options.take.parent_path() / "render"),
                           .description = take->description(),
                           .overlays = settings.overlays,
                           .view = settings.view,
                           .teaching = settings.teaching,
                           .size = options.size.value_or(settings.record.size),
                           .frames_per_second = options.frames_per_second.value_or(settings.record.frames_per_second),
                           .records = false,
                           .video = options.video,
                           .frames = options.frames,
                           .surfaces = options.surfaces,
                           .ground_truth = options.ground_truth,
                           .progress = stderr};
  refuse_folder_of_the_take(plan.folder, options.take);
  if (options.ground_truth) require_stress(take->moment(0).snapshot, options.take);
  const FolderLock lock(plan.folder);
  RecordingReport report = record_with_notes(
      *source, plan, renderer_painters(options.device, settings.record.tier, settings.view, options.stats));
  const std::vector<std::string> early = early_ends(takes);
  report.warnings.insert(report.warnings.end(), early.begin(), early.end());
  return conclude({.command = "render",
                   .source = options.take,
                   .device = options.device_text,
                   .overrides = options.overrides,
                   .preparation = preparation.wall,
                   .take_complete = early.empty()},
                  plan, report, options.json);
}

}  // namespace thinwall
