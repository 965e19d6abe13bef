#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studio/golden/GoldenComparison.hpp"
#include "studio/golden/GoldenHistory.hpp"
#include "studio/golden/ScenarioDifference.hpp"
#include "studio/golden/StateLayers.hpp"

namespace thinwall {

/// The stage of the way from scenario to picture that has changed.
enum class ChangedStage {
  kNothing,
  kPhysics,
  kLook,  // camera, light, look or else what is drawn of what the scenario asks for
  kRenderer,
  kOverlay,
  kTiming,   // which moments the frames of a video show
  kEncoder,  // frames are the same before it
  kUnknown,
};

/// "nothing", "physics", "look", "renderer", "overlay", "timing", "encoder", "unknown"
std::string stage_name(ChangedStage stage);

/// Why today's picture is not the golden one.
struct Attribution {
  ChangedStage stage = ChangedStage::kUnknown;
  std::string sentence;  // "physics changed from step 120 on (0.6 s): ...", "overlay changed: caption ..."
  HistoryChange history;
  std::vector<ScenarioChange> scenario;  // what the scenario says differently since the approval
  std::vector<std::string> overlay;      // what is written differently
  std::optional<Image> golden_state;     // the golden's state as today's renderer and look draw it, without overlays
  std::vector<StateLayer> layers = {};   // of the golden's state and today's, where the state is not the same
  std::optional<Image> golden_look;      // today's state in the golden's light and look, without overlays
};

/// Makes painters for the view of a resolved scenario (JSON).
using ViewPainters = std::function<PainterFactory(const std::string& resolved)>;

/// Holds today's picture against what the approval keeps: state, history, resolved scenario, texts and the picture
/// without overlays. Draws anew where that tells more; a device that has gone in the meantime takes only those
/// pictures.
Attribution attribute(const Scenario& scenario, const GoldenPicture& picture, const GoldenResult& result,
                      const std::filesystem::path& folder, const ViewPainters& painters);

/// What the history alone tells, without drawing: for pictures that are still within their limits.
HistoryChange history_change(const GoldenPicture& picture, const GoldenApproval& approval,
                             const std::filesystem::path& folder);

}  // namespace thinwall
