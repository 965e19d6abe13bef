#include "studio/golden/VideoAttribution.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studio/golden/NamedFiles.hpp"

namespace thinwall {
namespace {

/// For a sentence that is not the only place where all of them stand.
std::string first_of(std::vector<std::string> sentences) {
  constexpr std::size_t kMost = 1;
  const std::size_t more = sentences.size() - std::min(sentences.size(), kMost);
  if (more > 0) sentences.resize(kMost);
  return one_after_the_other(sentences) + (more > 0 ? fmt::format("; and {} more", more) : "");
}

/// A second take that has come or gone leaves the first as it was.
bool have_same_shared_states(const GoldenVideo& golden, const GoldenVideo& today) {
  const bool is_second_shared = !golden.second_state_digest.empty() && !today.second_state_digest.empty();
  return is_second_shared ? have_same_last_state(golden, today) : golden.state_digest == today.state_digest;
}

bool shows_same_scenes(const GoldenVideo& golden, const GoldenVideo& today) {
  return golden.driver == today.driver && golden.scene_hash == today.scene_hash;
}

/// The digest is of the last state, which may be as before after a way that was not, and another one where the scenario
/// lasts longer after the same way.
bool physics_changed(const Attribution& attribution, const GoldenVideo& golden, const GoldenVideo& today) {
  if (attribution.history.changed) return true;
  if (attribution.history.comparable && shows_same_scenes(golden, today)) return false;
  const bool goes_the_same_way = attribution.history.comparable && golden.frames.size() != today.frames.size();
  return !have_same_shared_states(golden, today) && !goes_the_same_way &&
         !list_changes(attribution.scenario, {ScenarioStage::kPhysics}).empty();
}

void tell_physics(Attribution& attribution, const GoldenVideo& golden, const GoldenVideo& today) {
  const std::string asked = list_changes(attribution.scenario, {ScenarioStage::kPhysics});
  attribution.stage = ChangedStage::kPhysics;
  attribution.sentence = "physics changed";
  if (attribution.history.changed) attribution.sentence += " " + attribution.history.sentence;
  attribution.sentence += told_cause_of_physics(golden.files, today.files, asked);
}

void tell_overlay(Attribution& attribution) {
  const std::string written = list_changes(attribution.scenario, {ScenarioStage::kOverlay});
  const std::string asked = list_changes(attribution.scenario, {ScenarioStage::kPhysics, ScenarioStage::kLook});
  attribution.stage = ChangedStage::kOverlay;
  attribution.sentence = "overlay changed, the pictures below are identical";
  if (!written.empty()) {
    attribution.sentence += ": " + written;
  } else if (!asked.empty()) {
    attribution.sentence += "; the scenario has changed: " + asked;
  }
}

void tell_pictures(Attribution& attribution, const GoldenVideo& golden, const GoldenVideo& today) {
  const std::string timing =
      list_changes(attribution.scenario, {ScenarioStage::kTiming, ScenarioStage::kPhysics, ScenarioStage::kLook});
  const std::string look = list_changes(attribution.scenario, {ScenarioStage::kLook});
  const std::string asked = list_changes(attribution.scenario, {ScenarioStage::kPhysics});
  const bool is_another_length = golden.frames.size() != today.frames.size();
  const bool is_of_timing = !list_changes(attribution.scenario, {ScenarioStage::kTiming}).empty();
  if (is_of_timing || (is_another_length && look.empty() && !asked.empty())) {
    attribution.stage = ChangedStage::kTiming;
    attribution.sentence = "timing of the video changed, states identical: " + timing;
  } else if (!look.empty()) {
    attribution.stage = ChangedStage::kLook;
    attribution.sentence = "look changed, states identical: " + look;
  } else if (!asked.empty()) {
    attribution.stage = ChangedStage::kLook;
    attribution.sentence = "pictures changed, states identical; the scenario has changed: " + asked;
  } else {
    attribution.stage = ChangedStage::kRenderer;
    attribution.sentence = golden.driver == today.driver ? "renderer changed, states and look identical"
                                                         : "renderer or driver changed, states and look identical";
  }
}

void tell_frames(Attribution& attribution, const GoldenVideo& golden, const GoldenVideo& today) {
  if (physics_changed(attribution, golden, today)) {
    tell_physics(attribution, golden, today);
  } else if (shows_same_scenes(golden, today)) {
    tell_overlay(attribution);
  } else {
    tell_pictures(attribution, golden, today);
  }
}

void tell_texts(Attribution& attribution, const std::vector<std::string>& texts) {
  const std::string written = list_changes(attribution.scenario, {ScenarioStage::kOverlay});
  attribution.stage = ChangedStage::kOverlay;
  attribution.sentence = "overlay changed: " + (written.empty() ? "" : written + "; ") + one_after_the_other(texts);
}

}  // namespace

bool have_same_last_state(const GoldenVideo& golden, const GoldenVideo& today) {
  return golden.state_digest == today.state_digest && golden.second_state_digest == today.second_state_digest;
}

Attribution attribute_video(const GoldenVideo& golden, const GoldenVideo& today, const VideoFindings& found) {
  Attribution attribution;
  attribution.history = compare_histories(parse_history(golden.history, "the golden video's history"),
                                          parse_history(today.history, "today's history"));
  attribution.scenario = compare_scenarios(golden.resolved, today.resolved);
  attribution.overlay = found.texts;
  if (!found.frames.empty()) {
    tell_frames(attribution, golden, today);
    attribution.sentence += "; " + first_of(found.before_encoder());
  } else if (!found.texts.empty()) {
    tell_texts(attribution, found.texts);
  } else {
    attribution.stage = ChangedStage::kEncoder;
    attribution.sentence =
        fmt::format("encoder changed, the {} frames before it are identical or within the limits: {}",
                    today.frames.size(), one_after_the_other(found.encoder));
  }
  return attribution;
}

std::string one_after_the_other(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
  return text;
}

}  // namespace thinwall
