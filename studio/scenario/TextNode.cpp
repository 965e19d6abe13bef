#include "studio/scenario/TextNode.hpp"

#include "studio/schema/Wording.hpp"

namespace thinwall {

const TextMember* TextNode::find(std::string_view key) const {
  for (const TextMember& member : members) {
    if (member.key == key) return &member;
  }
  return nullptr;
}

TextMember* TextNode::find(std::string_view key) {
  return const_cast<TextMember*>(static_cast<const TextNode*>(this)->find(key));
}

std::string describe(const TextNode& node) {
  switch (node.kind) {
    case NodeKind::kEmpty:
      return "nothing";
    case NodeKind::kList:
      return "a list";
    case NodeKind::kMapping:
      return "a mapping";
    case NodeKind::kText:
      break;
  }
  return in_backticks(node.text);
}

std::size_t count_nodes(const TextNode& node) {
  std::size_t count = 1;
  for (const TextNode& item : node.items) count += count_nodes(item);
  for (const TextMember& member : node.members) count += count_nodes(member.value);
  return count;
}

std::string member_path(const std::string& path, const std::string& key) {
  const std::string word = is_name(key) ? key : in_backticks(key);
  return path.empty() ? word : path + "." + word;
}

std::string item_path(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index + 1) + "]";
}

}  // namespace thinwall
