#include "studio/scenario/CutLint.hpp"

#include <array>
#include <optional>
#include <string_view>

#include "studio/scenario/CheckedReading.hpp"
#include "studio/scenario/TextNode.hpp"
#include "studio/schema/Quantity.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// A verb that opens walls, and the tool for it.
struct CuttingVerb {
  std::string_view verb;
  std::string_view tool;
  std::string_view other;   // the tool of the other verb, and that verb
  std::string_view advice;  // for who holds the other tool
};

constexpr std::array kVerbs = {
    CuttingVerb{"pierce", "needle", "scalpel", "; a scalpel cuts with `incise`"},
    CuttingVerb{"incise", "scalpel", "needle", "; a needle goes in with `pierce`"},
};

const CheckedValue* find_named(const CheckedValue& root, std::string_view section, const CheckedValue* name) {
  const CheckedValue* members = root.find(section);
  return members == nullptr || name == nullptr ? nullptr : members->find(name->text);
}

void check_tool(const CheckedMember& clip, const CheckedValue& tool, const CuttingVerb& verb, const std::string& path,
                Diagnostics& diagnostics) {
  const CheckedValue* kind = tool.find("kind");
  if (kind == nullptr) return;
  const CheckedValue& name = clip.value.at("tool");
  if (kind->text != verb.tool) {
    diagnostics.error(clip.location, path,
                      "only a " + in_backticks(verb.tool) + " can " + std::string(verb.verb) + ", and " +
                          in_backticks(name.text) + " is a " + in_backticks(kind->text) +
                          std::string(kind->text == verb.other ? verb.advice : ""));
    return;
  }
  const CheckedValue *depth = clip.value.find("depth"), *length = tool.find("length");
  if (depth == nullptr || length == nullptr || depth->number <= length->number) return;
  diagnostics.error(depth->location, path + ".depth",
                    in_backticks(name.text) + " is only " + format_like(length->number, "1 mm") +
                        " long; go less deep or give it a larger `length`");
}

void check_wall(const CheckedMember& clip, const CheckedValue& body, const CuttingVerb& verb, const std::string& path,
                Diagnostics& diagnostics) {
  const CheckedValue* wall = body.find("wall");
  if (wall == nullptr || wall->find("toughness") != nullptr || wall->has_wrong("toughness")) return;
  diagnostics.error(clip.location, path,
                    "the wall of " + in_backticks(clip.value.at("body").text) +
                        " has no toughness, so that what it "
                        "costs to " +
                        std::string(verb.verb) +
                        " it is not known; write `toughness: 0.4 kJ/m^2` or the like "
                        "in its `wall`");
}

void check_contents(const CheckedMember& body, Diagnostics& diagnostics) {
  const CheckedValue* contents = body.value.find("contents");
  const CheckedValue* leaks = contents == nullptr ? nullptr : contents->find("leaks");
  const CheckedValue* discharge = contents == nullptr ? nullptr : contents->find("discharge");
  if (leaks == nullptr || leaks->boolean || discharge == nullptr || !discharge->given) return;
  diagnostics.warning(discharge->location, member_path("bodies", body.key) + ".contents.discharge",
                      "has no effect on contents that do not leak");
}

/// The first clip of a verb that drives a tool: its number in the timeline from 0; none where there is none.
std::optional<std::size_t> first_clip(const CheckedValue& timeline, std::string_view verb, const std::string& tool) {
  for (std::size_t index = 0; index < timeline.items.size(); ++index) {
    const CheckedValue& item = timeline.items[index];
    if (item.members.empty() || item.members[0].key != verb) continue;
    if (find_text(item.members[0].value, "tool") == tool) return index;
  }
  return std::nullopt;
}

/// A blade that is only moved looks as if it cut, and does not.
void check_moved_edges(const CheckedValue& tools, const CheckedValue& timeline, Diagnostics& diagnostics) {
  for (const CheckedMember& tool : tools.members) {
    for (const CuttingVerb& verb : kVerbs) {
      if (find_text(tool.value, "kind") != verb.tool || first_clip(timeline, verb.verb, tool.key)) continue;
      const std::optional<std::size_t> moved = first_clip(timeline, "move", tool.key);
      if (!moved) continue;
      diagnostics.warning(timeline.items[*moved].members[0].location,
                          member_path(item_path("timeline", *moved), "move"),
                          in_backticks(tool.key) + " is a " + std::string(verb.tool) + " and no clip lets it " +
                              std::string(verb.verb) + ": walls that it is moved into give way and stay whole");
    }
  }
}

}  // namespace

void check_cuts(const CheckedValue& root, Diagnostics& diagnostics) {
  if (const CheckedValue* bodies = root.find("bodies")) {
    for (const CheckedMember& body : bodies->members) check_contents(body, diagnostics);
  }
  const CheckedValue *timeline = root.find("timeline"), *tools = root.find("tools");
  if (timeline != nullptr && tools != nullptr) check_moved_edges(*tools, *timeline, diagnostics);
  for (std::size_t index = 0; timeline != nullptr && index < timeline->items.size(); ++index) {
    const CheckedValue& item = timeline->items[index];
    if (item.members.empty()) continue;
    const CheckedMember& clip = item.members[0];
    for (const CuttingVerb& verb : kVerbs) {
      if (clip.key != verb.verb) continue;
      const std::string path = member_path(item_path("timeline", index), clip.key);
      const CheckedValue* tool = find_named(root, "tools", clip.value.find("tool"));
      const CheckedValue* body = find_named(root, "bodies", clip.value.find("body"));
      if (tool != nullptr) check_tool(clip, *tool, verb, path, diagnostics);
      if (body != nullptr) check_wall(clip, *body, verb, path, diagnostics);
    }
  }
}

}  // namespace thinwall
