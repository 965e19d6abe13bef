#include "studio/scenario/GraspLint.hpp"

#include <set>

#include "studio/scenario/TextNode.hpp"
#include "studio/schema/Quantity.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

void check_grasp(const CheckedMember& clip, const CheckedMember& tool, const std::string& path,
                 Diagnostics& diagnostics) {
  const CheckedValue* opening = tool.value.find("opening");
  const CheckedValue* to = clip.value.find("to");
  if (opening != nullptr && to != nullptr && to->number >= opening->number) {
    diagnostics.error(to->given ? to->location : clip.location, path + ".to",
                      "the jaws of " + in_backticks(tool.key) + " open to " + format_like(opening->number, "1 mm") +
                          " only; they must close to less");
  }
  const CheckedValue* friction = tool.value.find("friction");
  if (friction != nullptr && friction->number == 0) {
    diagnostics.warning(clip.location, path,
                        "jaws without friction let the wall slip; give " + in_backticks(tool.key) + " `friction`");
  }
}

const CheckedMember* find_member(const CheckedValue& mapping, const std::string& key) {
  for (const CheckedMember& member : mapping.members) {
    if (member.key == key) return &member;
  }
  return nullptr;
}

}  // namespace

void check_grasps(const CheckedValue& root, Diagnostics& diagnostics) {
  const CheckedValue *timeline = root.find("timeline"), *tools = root.find("tools");
  if (timeline == nullptr || tools == nullptr) return;
  std::set<std::string> closed;
  for (std::size_t index = 0; index < timeline->items.size(); ++index) {
    const CheckedValue& item = timeline->items[index];
    if (item.members.empty()) continue;
    const CheckedMember& clip = item.members[0];
    if (clip.key != "grasp" && clip.key != "release") continue;
    const CheckedValue* name = clip.value.find("tool");
    const CheckedMember* tool = name == nullptr ? nullptr : find_member(*tools, name->text);
    const CheckedValue* kind = tool == nullptr ? nullptr : tool->value.find("kind");
    if (kind == nullptr) continue;
    const std::string path = member_path(item_path("timeline", index), clip.key);
    if (kind->text != "forceps") {
      diagnostics.error(
          clip.location, path,
          "only `forceps` have jaws, and " + in_backticks(tool->key) + " is a " + in_backticks(kind->text));
    } else if (clip.key == "grasp") {
      check_grasp(clip, *tool, path, diagnostics);
      closed.insert(tool->key);
    } else if (closed.erase(tool->key) == 0) {
      diagnostics.error(clip.location, path, in_backticks(tool->key) + " holds nothing: no `grasp` comes before");
    }
  }
}

}  // namespace thinwall
