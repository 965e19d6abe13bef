#include "studio/golden/ScenarioDifference.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "studio/scenario/ResolvedDefaults.hpp"
#include "studio/scenario/WrittenValue.hpp"

namespace thinwall {
namespace {

using SortedJson = nlohmann::json;

/// Of what is below `teaching`: marks on walls are drawn with them, and cards take frames of their own.
ScenarioStage stage_of_teaching(const std::string& key) {
  for (const char* card : {"teaching.title_card", "teaching.end_card"}) {
    if (key.starts_with(card)) return key.ends_with(".text") ? ScenarioStage::kOverlay : ScenarioStage::kTiming;
  }
  if (key.starts_with("teaching.freezes") || key.starts_with("teaching.slow_motion")) return ScenarioStage::kTiming;
  return key.starts_with("teaching.highlights") ? ScenarioStage::kLook : ScenarioStage::kOverlay;
}

/// By the first word of the key, and by words that are written over the picture wherever they stand.
ScenarioStage stage_of(const std::string& key) {
  for (const char* word : {"caption", "chapter", "title"}) {
    if (key == word || key.ends_with(std::string(".") + word)) return ScenarioStage::kOverlay;
  }
  const std::string first = key.substr(0, key.find_first_of(".["));
  for (const char* word : {"bodies", "tools", "timeline", "simulation"}) {
    if (first == word) return ScenarioStage::kPhysics;
  }
  for (const char* beginning : {"look.overlays", "comparison.captions"}) {
    if (key.starts_with(beginning)) return ScenarioStage::kOverlay;
  }
  if (first == "teaching") return stage_of_teaching(key);
  if (first == "comparison") return ScenarioStage::kSecondTake;
  for (const char* word : {"camera", "cameras", "cuts", "lights", "look", "record"}) {
    if (first == word) return ScenarioStage::kLook;
  }
  return ScenarioStage::kNone;
}

std::string shortened(std::string text) {
  constexpr std::size_t kLongest = 100;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

/// Places of both scenarios, of which one may be without.
struct Pair {
  std::string key;
  const SortedJson* before = nullptr;
  const SortedJson* after = nullptr;
  std::optional<ValueSchema> schema = {};
};

class Collector {
 public:
  void collect(const Pair& pair) {
    const auto& [key, before, after, schema] = pair;
    if (before == nullptr || after == nullptr) return add(pair);
    if (*before == *after) return;
    if (before->is_object() && after->is_object()) return collect_members(pair);
    if (before->is_array() && after->is_array() && are_lists_of_items(*before, *after)) return collect_items(pair);
    add(pair);
  }
  std::vector<ScenarioChange> changes() { return std::move(changes_); }

 private:
  /// Lists of numbers are values by themselves. Of lists of another length only the end may have changed.
  static bool are_lists_of_items(const SortedJson& before, const SortedJson& after) {
    const SortedJson& longer = before.size() > after.size() ? before : after;
    if (!longer.front().is_structured()) return false;
    const auto common = static_cast<std::ptrdiff_t>(std::min(before.size(), after.size()));
    return before.size() == after.size() || std::equal(before.begin(), before.begin() + common, after.begin());
  }

  void collect_members(const Pair& pair) {
    std::set<std::string> names;
    for (const SortedJson* side : {pair.before, pair.after}) {
      for (const auto& [name, value] : side->items()) names.insert(name);
    }
    for (const std::string& name : names) {
      const SortedJson* before = pair.before->contains(name) ? &pair.before->at(name) : nullptr;
      const SortedJson* after = pair.after->contains(name) ? &pair.after->at(name) : nullptr;
      const SortedJson& mapping = after != nullptr ? *pair.after : *pair.before;
      collect({.key = pair.key.empty() ? name : pair.key + "." + name,
               .before = before,
               .after = after,
               .schema = pair.schema ? schema_below(*pair.schema, mapping, name) : std::nullopt});
    }
  }

  void collect_items(const Pair& pair) {
    for (std::size_t i = 0; i < std::max(pair.before->size(), pair.after->size()); ++i) {
      // Items count from 1, as in messages and in the paths of a comparison.
      collect({.key = pair.key + "[" + std::to_string(i + 1) + "]",
               .before = i < pair.before->size() ? &pair.before->at(i) : nullptr,
               .after = i < pair.after->size() ? &pair.after->at(i) : nullptr,
               .schema = pair.schema ? schema_of_item(*pair.schema, i) : std::nullopt});
    }
  }

  void add(const Pair& pair) {
    const auto text = [&](const SortedJson* side, const std::optional<ValueSchema>& schema) {
      return side != nullptr ? shortened(written_value(*side, schema)) : "";
    };
    std::string before = text(pair.before, pair.schema), after = text(pair.after, pair.schema);
    // What differs in further digits alone is told with all of them.
    if (before == after) before = text(pair.before, std::nullopt), after = text(pair.after, std::nullopt);
    changes_.push_back({.stage = stage_of(pair.key), .key = pair.key, .before = before, .after = after});
  }

  std::vector<ScenarioChange> changes_;
};

}  // namespace

std::string to_text(const ScenarioChange& change) {
  if (change.before.empty()) return change.key + " " + change.after + ", which was not there";
  if (change.after.empty()) return change.key + " is gone, it was " + change.before;
  return change.key + " " + change.after + " instead of " + change.before;
}

std::vector<ScenarioChange> compare_scenarios(const std::string& before, const std::string& after) {
  const SortedJson first = SortedJson::parse(with_defaults(before), nullptr, false);
  const SortedJson second = SortedJson::parse(with_defaults(after), nullptr, false);
  if (!first.is_object() || !second.is_object()) return {};
  Collector collector;
  collector.collect({.key = "", .before = &first, .after = &second, .schema = schema_of_scenario()});
  return collector.changes();
}

std::string list_changes(const std::vector<ScenarioChange>& changes, std::initializer_list<ScenarioStage> stages) {
  constexpr std::size_t kMost = 3;
  std::string text;
  std::size_t count = 0;
  const auto is_asked = [&](ScenarioStage stage) { return std::ranges::find(stages, stage) != stages.end(); };
  for (const ScenarioChange& change : changes) {
    const bool may_be_either = change.stage == ScenarioStage::kSecondTake &&
                               (is_asked(ScenarioStage::kPhysics) || is_asked(ScenarioStage::kLook));
    if (!is_asked(change.stage) && !may_be_either) continue;
    if (++count <= kMost) text += (text.empty() ? "" : ", ") + to_text(change);
  }
  if (count > kMost) text += " and " + std::to_string(count - kMost) + " more";
  return text;
}

}  // namespace thinwall
