#include "studio/golden/ScenarioDifference.hpp"

#include <nlohmann/json.hpp>

#include "studio/scenario/ResolvedDefaults.hpp"

namespace thinwall {
namespace {

using SortedJson = nlohmann::json;

/// By the first word of the key, and by words that are written over the picture wherever they stand.
ScenarioStage stage_of(const std::string& key) {
  for (const char* word : {"caption", "chapter", "title"}) {
    if (key == word || key.ends_with(std::string(".") + word)) return ScenarioStage::kOverlay;
  }
  const std::string first = key.substr(0, key.find_first_of(".["));
  for (const char* word : {"bodies", "tools", "timeline", "simulation"}) {
    if (first == word) return ScenarioStage::kPhysics;
  }
  for (const char* beginning : {"look.overlays", "comparison.captions", "teaching"}) {
    if (key.starts_with(beginning)) return ScenarioStage::kOverlay;
  }
  if (first == "comparison") return ScenarioStage::kSecondTake;
  for (const char* word : {"camera", "cameras", "cuts", "lights", "look", "record"}) {
    if (first == word) return ScenarioStage::kLook;
  }
  return ScenarioStage::kNone;
}

std::string value_text(const SortedJson& json) {
  std::string text = json.dump(-1, ' ', false, SortedJson::error_handler_t::replace);
  constexpr std::size_t kLongest = 60;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

void collect(const std::string& key, const SortedJson* before, const SortedJson* after,
             std::vector<ScenarioChange>& changes) {
  if (before != nullptr && after != nullptr && *before == *after) return;
  const bool both = before != nullptr && after != nullptr;
  const auto below = [&](const std::string& name) { return key.empty() ? name : key + "." + name; };
  if (both && before->is_object() && after->is_object()) {
    for (const auto& [name, value] : before->items()) {
      collect(below(name), &value, after->contains(name) ? &after->at(name) : nullptr, changes);
    }
    for (const auto& [name, value] : after->items()) {
      if (!before->contains(name)) collect(below(name), nullptr, &value, changes);
    }
    return;
  }
  if (both && before->is_array() && after->is_array() && before->size() == after->size() && !before->empty() &&
      before->front().is_structured()) {
    for (std::size_t i = 0; i < before->size(); ++i) {
      // Items count from 1, as in messages and in the paths of a comparison.
      collect(key + "[" + std::to_string(i + 1) + "]", &before->at(i), &after->at(i), changes);
    }
    return;
  }
  changes.push_back({.stage = stage_of(key),
                     .key = key,
                     .before = before != nullptr ? value_text(*before) : "",
                     .after = after != nullptr ? value_text(*after) : ""});
}

}  // namespace

std::string to_text(const ScenarioChange& change) {
  if (change.before.empty()) return change.key + " " + change.after + ", which was not there";
  if (change.after.empty()) return change.key + " is gone, it was " + change.before;
  return change.key + " " + change.after + " instead of " + change.before;
}

std::vector<ScenarioChange> compare_scenarios(const std::string& before, const std::string& after) {
  const SortedJson first = SortedJson::parse(with_defaults(before), nullptr, false);
  const SortedJson second = SortedJson::parse(with_defaults(after), nullptr, false);
  std::vector<ScenarioChange> changes;
  if (first.is_object() && second.is_object()) collect("", &first, &second, changes);
  return changes;
}

std::string list_changes(const std::vector<ScenarioChange>& changes, ScenarioStage stage) {
  constexpr std::size_t kMost = 3;
  std::string text;
  std::size_t count = 0;
  for (const ScenarioChange& change : changes) {
    const bool may_be_either = stage == ScenarioStage::kPhysics || stage == ScenarioStage::kLook;
    if (change.stage != stage && !(change.stage == ScenarioStage::kSecondTake && may_be_either)) continue;
    if (++count <= kMost) text += (text.empty() ? "" : ", ") + to_text(change);
  }
  if (count > kMost) text += " and " + std::to_string(count - kMost) + " more";
  return text;
}

}  // namespace thinwall
