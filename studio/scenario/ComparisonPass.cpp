#include "studio/scenario/ComparisonPass.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// A step of a path: `timeline[2]` is the second item of `timeline`.
struct PathStep {
  std::string key = {};
  std::optional<std::size_t> index = {};  // from 1, as it is written
};

std::vector<PathStep> steps_of(const std::string& path) {
  std::vector<PathStep> steps;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    PathStep step{.key = path.substr(begin, end - begin)};
    const std::size_t bracket = step.key.find('[');
    if (bracket != std::string::npos && step.key.ends_with(']')) {
      std::size_t number = 0;
      const char* last = step.key.data() + step.key.size() - 1;
      const auto [rest, error] = std::from_chars(step.key.data() + bracket + 1, last, number);
      if (error == std::errc{} && rest == last) {
        step.index = number;
        step.key.resize(bracket);
      }
    }
    steps.push_back(std::move(step));
    begin = end + 1;
  }
  return steps;
}

std::vector<std::string> keys_of(const TextNode& node) {
  std::vector<std::string> keys;
  for (const TextMember& member : node.members) keys.push_back(member.key);
  return keys;
}

/// What stands at a step below `node`; a key that is not there is added where that is allowed.
TextNode* below(TextNode& node, const PathStep& step, bool may_add, const SourceLocation& place) {
  TextMember* member = node.kind == NodeKind::kMapping ? node.find(step.key) : nullptr;
  if (member == nullptr && node.kind == NodeKind::kMapping && may_add && !step.index) {
    member = &node.members.emplace_back(TextMember{.key = step.key, .location = place});
  }
  if (member == nullptr) return nullptr;
  if (!step.index) return &member->value;
  std::vector<TextNode>& items = member->value.items;
  return *step.index >= 1 && *step.index <= items.size() ? &items[*step.index - 1] : nullptr;
}

/// Why nothing stands at a step below `node`.
std::string missing_step(TextNode& node, const PathStep& step) {
  const TextMember* member = node.kind == NodeKind::kMapping && step.index ? node.find(step.key) : nullptr;
  if (member == nullptr) {
    return "the scenario has no " + in_backticks(step.key) + " here" + did_you_mean(step.key, keys_of(node));
  }
  const std::size_t count = member->value.items.size();
  return in_backticks(step.key) + " has " + std::to_string(count) + (count == 1 ? " item" : " items") +
         ", which are counted from 1, and no item " + std::to_string(*step.index);
}

/// What both takes have in common: the pictures with what is written over them, and what the first one is judged by.
bool is_shared(const std::string& path) {
  constexpr std::array kShared = {"record.size", "record.fps", "record.video", "record.tier",
                                  "comparison",  "golden",     "expect",       "look.overlays"};
  return std::ranges::any_of(kShared, [&](const std::string& shared) {
    return path == shared || path.starts_with(shared + ".") || path.starts_with(shared + "[");
  });
}

void change(TextNode& root, const TextMember& wanted, Diagnostics& diagnostics) {
  const bool is_parameter = wanted.key.find('.') == std::string::npos;
  if (!is_parameter && is_shared(wanted.key)) {
    diagnostics.error(wanted.location, member_path("comparison.set", wanted.key),
                      "both takes have this in common, as they are in the same pictures; write it in its own place");
    return;
  }
  const std::vector<PathStep> steps = steps_of(is_parameter ? "parameters." + wanted.key : wanted.key);
  TextNode* node = &root;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool may_add = i + 1 == steps.size() && !is_parameter;
    TextNode* next = below(*node, steps[i], may_add, wanted.location);
    if (next == nullptr) {
      const std::string what = is_parameter ? "the scenario has no parameter " + in_backticks(wanted.key) +
                                                  did_you_mean(steps[i].key, keys_of(*node))
                                            : missing_step(*node, steps[i]);
      diagnostics.error(wanted.location, member_path("comparison.set", wanted.key), what);
      return;
    }
    node = next;
  }
  *node = wanted.value;
}

}  // namespace

void change_for_comparison(TextNode& root, Diagnostics& diagnostics) {
  const TextMember* comparison = root.find("comparison");
  if (comparison == nullptr) return;
  const TextMember* changes = comparison->value.find("set");
  if (changes == nullptr) return;
  const std::vector<TextMember> wanted = changes->value.members;  // a change may move the members of the root
  for (const TextMember& member : wanted) change(root, member, diagnostics);
}

Overrides overrides_for_comparison(const Overrides& overrides, const CheckedValue& comparison) {
  Overrides left;
  for (const auto& name_and_value : overrides) {
    if (comparison.at("set").find(name_and_value.first) == nullptr) left.push_back(name_and_value);
  }
  return left;
}

void comparison_lint(const CheckedValue& root, Diagnostics& diagnostics) {
  const CheckedValue* comparison = root.find("comparison");
  if (comparison == nullptr) return;
  const CheckedValue* changes = comparison->find("set");
  if (changes != nullptr && changes->members.empty()) {
    diagnostics.error(changes->location, "comparison.set",
                      "expected what the second take has different, as `thickness: 3 mm`");
  }
  const CheckedValue* cuts = root.find("cuts");
  for (std::size_t i = 0; cuts != nullptr && i < cuts->items.size(); ++i) {
    const CheckedValue* beside = cuts->items[i].find("beside");
    if (beside == nullptr) continue;
    diagnostics.error(beside->location, item_path("cuts", i) + ".beside",
                      "the right half shows the second take of `comparison`; use `inset`");
  }
}

}  // namespace thinwall
