#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

enum class NodeKind { kEmpty, kText, kList, kMapping };

struct TextMember;

/// A node of a scenario file before its texts have a meaning.
struct TextNode {
  NodeKind kind = NodeKind::kEmpty;
  SourceLocation location = {};
  std::string text = {};             // kText
  std::string cut_off = {};          // what YAML takes for a comment though it looks like the end of the text: "#1"
  std::string parameters = {};       // what was filled in, "`${depth}` is `4 mm`"; empty when nothing was
  bool told = false;                 // what is wrong here is told already: not to be read any further
  std::vector<TextNode> items = {};  // kList
  std::vector<TextMember> members;   // kMapping, in the order of the file, no key twice; its type is whole below

  /// The member of that key, or nullptr.
  const TextMember* find(std::string_view key) const;
  TextMember* find(std::string_view key);
};

struct TextMember {
  std::string key = {};
  SourceLocation location = {};  // of the key
  TextNode value = {};
};

/// "a list", "a mapping", "nothing", or the quoted text.
std::string describe(const TextNode& node);

/// The number of nodes from this one down.
std::size_t count_nodes(const TextNode& node);

/// "bodies.organ": the path of a member; a key that is no plain name is quoted. An empty `path` is the root.
std::string member_path(const std::string& path, const std::string& key);

/// "timeline[1]": the path of a list's item; `index` counts from 0, the words from 1 like lines and columns.
std::string item_path(const std::string& path, std::size_t index);

}  // namespace thinwall
