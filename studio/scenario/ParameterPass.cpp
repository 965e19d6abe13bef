#include "studio/scenario/ParameterPass.hpp"

#include <map>
#include <set>

#include "studio/scenario/YamlReader.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

constexpr std::size_t kLongestText = 10000;    // bytes, after filling in
constexpr std::size_t kMostFilledIn = 100000;  // nodes

enum class State { kUnread, kReading, kDone };

struct Parameter {
  SourceLocation location;  // of the name
  TextNode value;
  State state = State::kUnread;
  bool used = false;
};

bool is_plain(const TextNode& node) {
  if (node.kind == NodeKind::kText) return true;
  if (node.kind != NodeKind::kList) return false;
  for (const TextNode& item : node.items) {
    if (!is_plain(item)) return false;
  }
  return true;
}

class ParameterFiller {
 public:
  explicit ParameterFiller(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void read(const TextMember& section) {
    const TextNode& mapping = section.value;
    if (mapping.kind == NodeKind::kEmpty) return;
    if (mapping.kind != NodeKind::kMapping) {
      diagnostics_.error(mapping.location, "parameters", "expected a mapping, got " + describe(mapping));
      return;
    }
    for (const TextMember& member : mapping.members) {
      const std::string path = member_path("parameters", member.key);
      if (!is_name(member.key)) {
        diagnostics_.error(member.location, path, name_mistake(member.key));
      } else if (!is_plain(member.value)) {
        diagnostics_.error(member.location, path,
                           "expected a default, a text or a list, got " + describe(member.value));
        known_bad_.insert(member.key);
      } else {
        parameters_[member.key] = {member.location, member.value};
        names_.push_back(member.key);
      }
    }
  }

  void override_with(const Overrides& overrides, const SourceLocation& section) {
    std::set<std::string> seen;
    for (const auto& [name, value] : overrides) {
      const std::string option = "--set " + name + "=" + value;
      const auto parameter = parameters_.find(name);
      if (!seen.insert(name).second) {
        diagnostics_.error(section, "", in_backticks(option) + ": " + in_backticks(name) + " is set twice");
      } else if (parameter != parameters_.end()) {
        const SourceLocation place = parameter->second.value.location;
        parameter->second.value = override_node(value, place);
      } else if (!known_bad_.contains(name)) {
        diagnostics_.absence(
            section, "",
            in_backticks(option) + ": the scenario has no parameter " + in_backticks(name) + hint_for(name));
      }
    }
  }

  /// Fills in this node and all below it.
  void fill(TextNode& node, const std::string& path) {
    if (node.told) return;
    if (node.kind == NodeKind::kText && node.text.find("${") != std::string::npos) node.told = !fill_text(node, path);
    for (std::size_t index = 0; index < node.items.size(); ++index) fill(node.items[index], item_path(path, index));
    for (TextMember& member : node.members) fill(member.value, member_path(path, member.key));
  }

  /// Fills in the parameters themselves, used or not, so that the resolved scenario has their final texts.
  void finish(TextMember* section, UnusedParameters unused) {
    for (const std::string& name : names_) {
      Parameter& parameter = parameters_[name];
      if (!parameter.used && unused == UnusedParameters::kRefused) {
        diagnostics_.absence(
            parameter.location, member_path("parameters", name),
            "nothing uses this parameter; write `${" + name + "}` where its value belongs, or leave it out");
      } else if (section != nullptr) {
        section->value.find(name)->value = parameter.value;
      }
    }
  }

 private:
  /// What a name that no parameter has may have been meant to be.
  std::string hint_for(const std::string& name) const {
    const std::string meant = did_you_mean(name, names_);
    if (!meant.empty()) return meant;
    if (names_.empty()) return "; there is none: `parameters: { " + name + ": ... }` gives it";
    return "; there is " + list_in_backticks(names_);
  }

  static TextNode override_node(const std::string& value, const SourceLocation& place) {
    TextNode text{.kind = NodeKind::kText, .location = place, .text = value, .members = {}};
    if (!value.starts_with("[")) return text;
    Diagnostics ignored;
    std::optional<TextNode> list = read_yaml_text(value, place.file, ignored);
    if (!list || !ignored.errors.empty() || !is_plain(*list)) return text;
    move_to(*list, place);
    return *list;
  }

  static void move_to(TextNode& node, const SourceLocation& place) {
    node.location = place;
    for (TextNode& item : node.items) move_to(item, place);
  }

  static void note(TextNode& node, const std::string& words) {
    if (node.parameters.size() < 200) node.parameters += (node.parameters.empty() ? "" : ", ") + words;
    for (TextNode& item : node.items) note(item, words);
  }

  /// The parameter with its own `${...}` filled in; nullptr when there is none or it needs itself.
  const Parameter* resolve(const std::string& name, const SourceLocation& place, const std::string& path) {
    const auto found = parameters_.find(name);
    if (found == parameters_.end()) {
      if (!known_bad_.contains(name)) {
        diagnostics_.absence(place, path, "there is no parameter " + in_backticks(name) + hint_for(name));
      }
      return nullptr;
    }
    Parameter& parameter = found->second;
    parameter.used = true;
    if (parameter.state == State::kReading) {
      diagnostics_.error(place, path, "the parameter " + in_backticks(name) + " needs itself");
      return nullptr;
    }
    if (parameter.state == State::kUnread) {
      parameter.state = State::kReading;
      fill(parameter.value, member_path("parameters", name));
      parameter.state = State::kDone;
    }
    return &parameter;
  }

  /// False after an error.
  bool fill_text(TextNode& node, const std::string& path) {
    const std::string text = node.text;
    std::string filled;
    std::string parameters;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t begin = text.find("${", at);
      filled += text.substr(at, begin - at);
      if (begin == std::string::npos) break;
      const std::size_t end = text.find('}', begin);
      const std::string name = text.substr(begin + 2, end == std::string::npos ? end : end - begin - 2);
      if (end == std::string::npos || !is_name(name)) {
        diagnostics_.error(node.location, path,
                           "expected `${name}` with the name of a parameter, got " + in_backticks(text));
        return false;
      }
      const Parameter* parameter = resolve(name, node.location, path);
      if (parameter == nullptr || parameter->value.told) return false;
      const bool is_whole = begin == 0 && end + 1 == text.size();
      if (is_whole) return replace(node, *parameter, name, path);
      if (parameter->value.kind != NodeKind::kText) {
        diagnostics_.error(node.location, path,
                           "the list " + in_backticks("${" + name + "}") + " cannot stand inside a text");
        return false;
      }
      filled += parameter->value.text;
      parameters += (parameters.empty() ? "" : ", ") + describe_use(name, parameter->value);
      if (filled.size() > kLongestText) {
        diagnostics_.error(node.location, path,
                           "the text is longer than 10000 bytes when its parameters are filled in");
        return false;
      }
      at = end + 1;
    }
    node.text = filled;
    if (node.parameters.size() + parameters.size() < kLongestText) node.parameters += parameters;
    return true;
  }

  static std::string describe_use(const std::string& name, const TextNode& value) {
    return "`${" + name + "}` is " + describe(value);
  }

  bool replace(TextNode& node, const Parameter& parameter, const std::string& name, const std::string& path) {
    filled_in_ += count_nodes(parameter.value);
    if (filled_in_ > kMostFilledIn) {
      diagnostics_.error(node.location, path, "more than 100000 values when parameters are filled in");
      return false;
    }
    const SourceLocation place = node.location;
    node = parameter.value;
    move_to(node, place);
    note(node, describe_use(name, parameter.value));
    return !node.told;
  }

  Diagnostics& diagnostics_;
  std::map<std::string, Parameter> parameters_;
  std::vector<std::string> names_;   // in the order of the file
  std::set<std::string> known_bad_;  // told already
  std::size_t filled_in_ = 0;
};

}  // namespace

void parameter_pass(TextNode& root, const Overrides& overrides, Diagnostics& diagnostics, UnusedParameters unused) {
  ParameterFiller filler(diagnostics);
  TextMember* section = root.find("parameters");
  if (section != nullptr) filler.read(*section);
  filler.override_with(overrides, section != nullptr ? section->location : SourceLocation{root.location.file, 1, 1});
  for (TextMember& member : root.members) {
    if (member.key != "parameters") filler.fill(member.value, member.key);
  }
  filler.finish(section, unused);
}

}  // namespace thinwall
