#include "studio/golden/Attribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "studio/golden/NamedFiles.hpp"
#include "studio/golden/OverlayRecord.hpp"
#include "studio/take/TakeError.hpp"
#include "studio/take/TakeReader.hpp"

namespace thinwall {
namespace {

/// Levels by which processors that round otherwise draw the same; up to 2 were seen among the goldens.
constexpr int kLevelsOfRounding = 2;

/// What the golden's takes hold; empty when they cannot be read, or are not those that were approved.
struct StoredState {
  std::optional<Moment> moment;  // with the second take's
  std::string resolved;
};

StoredState stored_take(const std::filesystem::path& file, const std::string& digest) {
  try {
    const TakeReader take(file);
    if (take.times().empty() || !is_approved_state(take, digest)) return {};
    return {.moment = take.moment(0), .resolved = take.description().resolved};
  } catch (const TakeError&) {
    return {};
  }
}

/// A state does not tell which tools its picture leaves out: the approval does, or, of earlier versions, today's
/// moment.
void set_aside(Snapshot& golden, const std::optional<std::vector<std::string>>& names, const Snapshot& today) {
  for (SnapshotTool& tool : golden.tools) {
    if (names) {
      tool.is_set_aside = std::ranges::find(*names, tool.name) != names->end();
      continue;
    }
    const auto same = std::ranges::find(today.tools, tool.name, &SnapshotTool::name);
    tool.is_set_aside = same != today.tools.end() && same->is_set_aside;
  }
}

StoredState stored_state(const std::filesystem::path& folder, const GoldenApproval& approval, const Moment& today) {
  StoredState stored = stored_take(folder / approval.state, approval.state_digest);
  if (!stored.moment) return stored;
  set_aside(stored.moment->snapshot, approval.set_aside, today.snapshot);
  if (approval.second_state.empty()) return stored;
  StoredState second = stored_take(folder / approval.second_state, approval.second_state_digest);
  if (!second.moment) return stored;
  set_aside(second.moment->snapshot, approval.second_set_aside, today.second ? today.second->snapshot : Snapshot{});
  stored.moment->second = std::make_shared<const Moment>(*std::move(second.moment));
  return stored;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

/// A moment as today's picture shows it. Nothing when there is no device any more.
std::optional<Image> drawn(const Moment& moment, const GoldenPicture& today, const PainterFactory& painters) {
  Shot shot = today.shot;
  if (moment.second) shot.beside_snapshot = {moment.second, &moment.second->snapshot};
  try {
    return painters(today.image.size)->paint(moment.snapshot, shot);
  } catch (const PictureFailure&) {
    return std::nullopt;
  }
}

/// Of the first take, unless the second alone is not as it was.
std::vector<StateLayer> changed_layers(const Moment& golden, const GoldenPicture& today,
                                       const GoldenApproval& approval) {
  const bool only_second = golden.second && today.moment.second && approval.state_digest == today.state_digest;
  if (!only_second) {
    return state_layers(golden.snapshot, today.moment.snapshot, today.shot, today.image.size);
  }
  const Shot shot{.camera = *today.shot.beside};
  std::vector<StateLayer> layers =
      state_layers(golden.second->snapshot, today.moment.second->snapshot, shot, today.image.size);
  for (StateLayer& layer : layers) layer.verdict = "second take: " + layer.verdict;
  return layers;
}

struct Evidence {
  const GoldenPicture& picture;
  const std::filesystem::path& folder;
  const GoldenResult& result;
  const GoldenApproval& approval;
  Attribution& attribution;
  bool knows_scenario;  // what the golden's scenario asked for
  std::string files;    // a record of those that the scenario names today
  bool same_driver() const { return approval.driver == result.driver; }
  /// Only where the approval kept it, and the same driver drew.
  bool knows_scene() const { return same_driver() && !approval.scene_hash.empty() && !picture.scene_hash.empty(); }
  bool shows_same_scene() const { return knows_scene() && picture.scene_hash == approval.scene_hash; }
};

bool physics_changed(const Evidence& evidence) {
  // A state that is as before may be reached by a way that is not: then the force plot shows it, and nothing else.
  if (evidence.result.state.verdict == StateVerdict::kEqual) {
    return evidence.attribution.history.changed && evidence.shows_same_scene();
  }
  return evidence.result.state.verdict == StateVerdict::kChanged || evidence.attribution.history.changed;
}

/// What the scenario says differently of the picture, where the physics has changed as well.
void tell_besides(Attribution& attribution) {
  const std::string look = list_changes(attribution.scenario, {ScenarioStage::kLook});
  const std::string written = list_changes(attribution.scenario, {ScenarioStage::kOverlay});
  // What a second take sets may be of either stage, and is told as the cause.
  const bool is_of_look = std::ranges::any_of(
      attribution.scenario, [](const ScenarioChange& change) { return change.stage == ScenarioStage::kLook; });
  if (is_of_look) attribution.sentence += "; the look has changed too: " + look;
  if (!written.empty()) attribution.sentence += "; the overlay has changed too: " + written;
}

/// By how many levels the golden's state as it is drawn today is other than in the golden's picture, where nothing is
/// written over that. Nothing where words stand elsewhere than today, or among the tissue.
std::optional<int> drawn_apart(const Evidence& evidence, const Attribution& attribution) {
  const GoldenPicture& today = evidence.picture;
  if (today.is_annotated || !list_changes(attribution.scenario, {ScenarioStage::kOverlay}).empty()) return std::nullopt;
  Image golden, drawn = *attribution.golden_state;
  try {
    golden = read_png(evidence.folder / evidence.approval.image);
  } catch (const ImageUnreadable&) {
    return std::nullopt;  // the comparison tells that it is lost
  }
  if (golden.size != drawn.size || golden.size != today.scene.size) return std::nullopt;
  for (std::size_t k = 0; k < golden.pixels.size(); k += 3) {
    const auto pixel = [&](const Image& image) { return std::span(image.pixels).subspan(k, 3); };
    if (!std::ranges::equal(pixel(today.scene), pixel(today.image))) {
      std::ranges::copy(pixel(golden), drawn.pixels.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
  return compare_images(golden, drawn).largest;
}

/// Whether the renderer has changed as well: a picture that is other by a rounding of the driver does not tell so.
std::string told_drawing(const Evidence& evidence, const Attribution& attribution) {
  if (image_hash(*attribution.golden_state) == evidence.approval.scene_hash) {
    return "; the renderer draws the golden's state as before";
  }
  const std::optional<int> levels = drawn_apart(evidence, attribution);
  if (!levels) return "; the golden's state is drawn differently too";
  const std::string by = fmt::format("{} level{}", *levels, *levels == 1 ? "" : "s");
  return *levels <= kLevelsOfRounding ? "; the renderer draws the golden's state as before, to " + by
                                      : "; the golden's state is drawn differently too, by up to " + by;
}

void tell_physics(const Evidence& evidence, Attribution& attribution) {
  attribution.stage = ChangedStage::kPhysics;
  attribution.sentence = "physics changed";
  if (attribution.history.changed) {
    attribution.sentence += " " + attribution.history.sentence;
  }
  if (evidence.result.state.verdict == StateVerdict::kChanged) {
    attribution.sentence += "; " + evidence.result.state.explanation;
  }
  const std::string asked = list_changes(attribution.scenario, {ScenarioStage::kPhysics});
  if (!evidence.knows_scenario) {
    attribution.sentence += "; whether the scenario asks for the same is open, as the golden's cannot be read";
  } else {
    attribution.sentence += told_cause_of_physics(evidence.approval.files, evidence.files, asked);
  }
  tell_besides(attribution);
  if (!evidence.knows_scene() || !attribution.golden_state) return;
  attribution.sentence += told_drawing(evidence, attribution);
}

/// What stands over the picture is of the scenario's words or, as a time or a curve, of what it asks to happen.
void tell_overlay(Attribution& attribution) {
  attribution.stage = ChangedStage::kOverlay;
  const std::string written = list_changes(attribution.scenario, {ScenarioStage::kOverlay});
  const std::string asked = list_changes(attribution.scenario, {ScenarioStage::kPhysics, ScenarioStage::kLook});
  const std::string words = written.empty() ? joined(attribution.overlay) : written;
  if (words.empty() && asked.empty()) {
    attribution.sentence = "overlay drawn differently, its texts and the picture below are identical";
    return;
  }
  attribution.sentence = "overlay changed" + (words.empty() ? "" : ": " + words);
  // A caption may tell what has changed before that has come to anything, as a depth that is not reached yet.
  const std::string besides = written.empty() ? "" : " too";
  if (!asked.empty()) attribution.sentence += "; the scenario has changed" + besides + ": " + asked;
  attribution.sentence += "; the picture below is identical";
}

void tell_renderer(const Evidence& evidence, Attribution& attribution) {
  attribution.stage = ChangedStage::kRenderer;
  attribution.sentence = evidence.same_driver() ? "renderer changed, state and look identical"
                                                : "renderer or driver changed, state and look identical";
  if (!evidence.approval.state.empty() && evidence.result.state.verdict == StateVerdict::kUnknown) {
    attribution.stage = ChangedStage::kUnknown;
    attribution.sentence = "it is open what has changed: " + evidence.result.state.explanation;
  }
}

void tell_picture(const Evidence& evidence, Attribution& attribution) {
  if (evidence.shows_same_scene()) return tell_overlay(attribution);
  const std::string look = list_changes(attribution.scenario, {ScenarioStage::kLook});
  // As the radius of a tool that touches nothing yet.
  const std::string asked = list_changes(attribution.scenario, {ScenarioStage::kPhysics});
  const std::string written = list_changes(attribution.scenario, {ScenarioStage::kOverlay});
  const std::string words = written.empty() ? joined(attribution.overlay) : written;
  if (!look.empty()) {
    attribution.stage = ChangedStage::kLook;
    attribution.sentence = "look changed, state identical: " + look;
    if (!written.empty()) attribution.sentence += "; the overlay has changed too: " + written;
  } else if (!words.empty() && !evidence.knows_scene()) {
    attribution.stage = ChangedStage::kOverlay;
    attribution.sentence = "overlay changed: " + words;
  } else if (!asked.empty()) {
    attribution.stage = ChangedStage::kLook;
    attribution.sentence = "picture changed, state identical; the scenario has changed: " + asked;
  } else {
    tell_renderer(evidence, attribution);
  }
}

}  // namespace

std::string stage_name(ChangedStage stage) {
  switch (stage) {
    case ChangedStage::kNothing:
      return "nothing";
    case ChangedStage::kPhysics:
      return "physics";
    case ChangedStage::kLook:
      return "look";
    case ChangedStage::kRenderer:
      return "renderer";
    case ChangedStage::kOverlay:
      return "overlay";
    case ChangedStage::kTiming:
      return "timing";
    case ChangedStage::kEncoder:
      return "encoder";
    case ChangedStage::kUnknown:
      return "unknown";
  }
  return "";
}

HistoryChange history_change(const GoldenPicture& picture, const GoldenApproval& approval,
                             const std::filesystem::path& folder) {
  if (approval.history.empty()) return {};
  const std::filesystem::path file = folder / approval.history;
  try {
    return compare_histories(parse_history(bytes_of_file(file), file.string()), picture.history);
  } catch (const GoldenError&) {
    // The comparison tells that it is lost.
    return {};
  }
}

Attribution attribute(const Scenario& scenario, const GoldenPicture& picture, const GoldenResult& result,
                      const std::filesystem::path& folder, const ViewPainters& painters) {
  Attribution attribution;
  const std::vector<GoldenApproval> approvals = read_approvals(folder);
  const GoldenApproval* approval = find_approval(approvals, result.at, result.driver);
  if (approval == nullptr || !picture.missing.empty()) {
    attribution.sentence = "there is nothing to compare with";
    return attribution;
  }
  const StoredState golden = stored_state(folder, *approval, picture.moment);
  attribution.history = history_change(picture, *approval, folder);
  attribution.scenario = compare_scenarios(golden.resolved, scenario.resolved);
  attribution.overlay = compare_overlays(approval->overlay, overlay_record(picture.overlay));
  const Evidence evidence{
      picture, folder, result, *approval, attribution, !golden.resolved.empty(), named_files_record(scenario)};
  if (physics_changed(evidence)) {
    if (golden.moment) attribution.golden_state = drawn(*golden.moment, picture, painters(scenario.resolved));
    tell_physics(evidence, attribution);
  } else {
    tell_picture(evidence, attribution);
  }
  if (golden.moment && result.state.verdict != StateVerdict::kEqual) {
    attribution.layers = changed_layers(*golden.moment, picture, *approval);
  }
  if (!list_changes(attribution.scenario, {ScenarioStage::kLook}).empty() && !golden.resolved.empty()) {
    attribution.golden_look = drawn(picture.moment, picture, painters(golden.resolved));
  }
  return attribution;
}

}  // namespace thinwall
