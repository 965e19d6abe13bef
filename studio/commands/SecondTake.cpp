#include "studio/commands/SecondTake.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"
#include "studio/commands/DataViewRange.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/recorder/OutputFolder.hpp"
#include "studio/recorder/PairedSource.hpp"
#include "studio/recorder/Recorder.hpp"
#include "studio/recorder/ResolvedPicture.hpp"
#include "studio/take/TakeError.hpp"
#include "studio/take/TakeReader.hpp"

namespace thinwall {
namespace {

/// A take that is read as it is shown.
class OwnedTakeSource final : public MomentSource {
 public:
  explicit OwnedTakeSource(const std::filesystem::path& file) : take_(file), source_(take_) {}
  std::optional<Moment> next() override { return source_.next(); }
  std::vector<std::string> warnings() const override { return source_.warnings(); }
  std::string state_digest() const override { return source_.state_digest(); }

  const TakeReader& take() const { return take_; }

 private:
  TakeReader take_;
  TakeSource source_;
};

/// Where a recording in `folder` makes the take that it is compared with, until it is whole itself.
std::filesystem::path unfinished_folder(const std::filesystem::path& folder) {
  return unfinished_name(folder / kSecondTakeFolder);
}

/// Where the take that is compared with `take` is.
std::filesystem::path second_take_of(const std::filesystem::path& take) {
  const bool was_stopped = take.filename() == unfinished_name("take.h5");
  const std::filesystem::path folder = take.parent_path();
  return (was_stopped ? unfinished_folder(folder) : folder / kSecondTakeFolder) / "take.h5";
}

/// The captions of the comparison in a resolved scenario, where it has one.
std::optional<std::array<std::string, 2>> captions_of(const std::string& resolved) {
  const nlohmann::json scenario = nlohmann::json::parse(resolved, nullptr, false);
  if (!scenario.is_object() || !scenario.contains("comparison")) return std::nullopt;
  return scenario.at("comparison").at("captions").get<std::array<std::string, 2>>();
}

/// The ends of the second take's colours where it is not told them: what both show has the same colours in both.
void find_ends(const std::filesystem::path& take, const LookDefinition& first, LookDefinition& second) {
  if (!second.data || (second.data->from && second.data->to)) return;
  const bool is_same = first.data && first.data->quantity == second.data->quantity;
  if (is_same) {
    second.data = first.data;
  } else {
    complete_data_range({take}, second);
  }
}

}  // namespace

RecordedTakes record_second_take(const Scenario& scenario, const std::filesystem::path& folder) {
  if (!scenario.comparison) return {simulate_one_take(scenario)};
  const Scenario& second = *scenario.comparison->second;
  const RecordingPlan plan{.folder = unfinished_folder(folder),
                           .description = {.name = second.name, .title = second.title, .resolved = second.resolved},
                           .overlays = second.overlays,
                           .size = second.record.size,
                           .frames_per_second = second.record.frames_per_second,
                           .pictures = false,
                           .video = false,
                           .progress = stderr};
  const std::unique_ptr<MomentSource> simulation = simulate_one_take(second);
  RecordingReport report = record(*simulation, plan, {});
  return {pair_sources(simulate_one_take(scenario), std::make_unique<OwnedTakeSource>(plan.folder / "take.h5")),
          std::move(report.failure), report.simulated};
}

void keep_second_take(const Scenario& scenario, const std::filesystem::path& folder) {
  const std::filesystem::path made = unfinished_folder(folder);
  if (!scenario.comparison) return remove_second_take(made);
  std::error_code error;
  std::filesystem::rename(made, folder / kSecondTakeFolder, error);
  if (!error) return;
  throw PictureFailure("cannot rename " + made.string() + ": " + error.message() + "; " +
                       cure_for_write_error(error.value()));
}

std::vector<std::filesystem::path> takes_shown(const std::filesystem::path& take) {
  if (!captions_of(TakeReader(take).description().resolved)) return {take};
  const std::filesystem::path second = second_take_of(take);
  if (std::filesystem::exists(second)) return {take, second};
  if (std::filesystem::absolute(take).parent_path().filename() == kSecondTakeFolder) {
    const std::filesystem::path first = (take.parent_path() / ".." / "take.h5").lexically_normal();
    throw TakeError(take.string() + ": it is the second take of a comparison; name the first, " + first.string() +
                    ", which is shown beside it");
  }
  throw TakeError(take.string() + ": the take is compared with " + second.string() +
                  ", which is not there; run the scenario again");
}

std::unique_ptr<MomentSource> replay_takes(const std::vector<std::filesystem::path>& takes, const CommonLook& common,
                                           ViewDefinition& view, const std::optional<ViewDefinition>& second_view) {
  auto first = std::make_unique<OwnedTakeSource>(takes.front());
  if (takes.size() == 1) return first;
  auto second = std::make_unique<OwnedTakeSource>(takes.back());
  const auto captions = captions_of(first->take().description().resolved);
  const std::string& resolved = second->take().description().resolved;
  const auto own_captions = captions_of(resolved);
  if (!own_captions)
    throw TakeError(takes.back().string() + ": is not the second take of a comparison; run the scenario again");
  TakeComparison comparison{{captions->front(), own_captions->back()},
                            second_view ? *second_view : picture_settings(resolved).view};
  LookDefinition& second_look = comparison.second.look;
  if (common.data) second_look.data = view.look.data;
  if (common.mesh) second_look.mesh = view.look.mesh;
  find_ends(takes.back(), view.look, second_look);
  view.comparison = std::make_shared<const TakeComparison>(std::move(comparison));
  return pair_sources(std::move(first), std::move(second));
}

void prepare_truth(ViewDefinition& view) {
  if (view.comparison) {
    throw UsageError(
        "--aov: ground truth is of one take, and the scenario's `comparison` shows two; leave --aov out, or "
        "record each take by itself, without `comparison`");
  }
  view.look.flat_triangles = true;
}

}  // namespace thinwall
