#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/camera/View.hpp"
#include "studio/commands/RunSource.hpp"

namespace thinwall {

/// Simulates the second take of a scenario with a comparison and records it below `folder`, without pictures and under
/// the name of what is not finished, so that an earlier recording stays whole; then the source of both takes. Without a
/// comparison, the source of the one. `failure`: why the second take could not go on; empty
/// when it reached its end. `second_duration`: of the second take, seconds; zero without one.
struct RecordedTakes {
  std::unique_ptr<MomentSource> source;
  std::string failure = {};
  double second_duration = 0;
};
RecordedTakes record_second_take(const Scenario& scenario, const std::filesystem::path& folder);

/// Once both takes are recorded: gives the second its name. Without a comparison, removes what a run that was stopped
/// has left of one. Throws PictureFailure.
void keep_second_take(const Scenario& scenario, const std::filesystem::path& folder);

/// A take and, where its scenario compares, the second one. Throws TakeError when the second one is missing.
std::vector<std::filesystem::path> takes_shown(const std::filesystem::path& take);

/// What of the first take's look holds for the second, too, whatever that was recorded with, as a command line asks
/// for.
struct CommonLook {
  bool data = false;  // the numbers in colours
  bool mesh = false;  // the edges of the mesh
};

/// What takes_shown gives, side by side where they are two; `view` then is told of the second, which is seen as
/// `second_view` says, or as it was recorded. Where both show the same quantity, and the second is not told the ends of
/// its colours, they are those of the first.
std::unique_ptr<MomentSource> replay_takes(const std::vector<std::filesystem::path>& takes, const CommonLook& common,
                                           ViewDefinition& view, const std::optional<ViewDefinition>& second_view);

/// For pictures with ground truth: walls are drawn as the triangles of the mesh, where researchers find them. Throws
/// UsageError where two takes are shown.
void prepare_truth(ViewDefinition& view);

}  // namespace thinwall
