#include "studio/scenario/ReferencePass.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "studio/scenario/NameCheck.hpp"
#include "studio/scenario/TextNode.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// The groups of vertices that the surface of a shape has.
std::vector<std::string> groups_of_shape(const CheckedValue& surface) {
  const std::string& shape = surface.at("shape").text;
  const CheckedValue* slit = surface.find("slit");
  if (slit != nullptr && slit->boolean) return {"wall", "inner", "outer", "slit_start", "slit_end"};
  if (shape == "annulus") return {"wall", "inner", "outer"};
  if (shape == "hemisphere") return {"wall", "base"};
  if (shape == "semicylinder") return {"wall", "base", "ends"};
  if (shape == "cylinder") return {"wall", "ends"};
  return {"wall"};
}

/// What a clip's key may name.
struct Reference {
  std::string key;      // "tool"
  std::string what;     // "tool"
  std::string section;  // "tools"
  bool needed = true;   // whether more than one name needs a choice
};

class ReferenceChecker {
 public:
  ReferenceChecker(CheckedValue& root, Diagnostics& diagnostics)
      : root_(root),
        diagnostics_(diagnostics),
        tools_(choice_of(names_in(root, "tools"))),
        bodies_(choice_of_bodies(root)) {}

  void check_clips() {
    CheckedValue* timeline = root_.find("timeline");
    if (timeline == nullptr) return;
    for (std::size_t index = 0; index < timeline->items.size(); ++index) {
      CheckedValue& item = timeline->items[index];
      if (item.members.empty()) continue;
      CheckedMember& clip = item.members[0];
      const std::string path = member_path(item_path("timeline", index), clip.key);
      const bool meets_body =
          clip.key == "palpate" || clip.key == "pierce" || clip.key == "incise" || clip.key == "grasp";
      if (meets_body || clip.key == "move" || clip.key == "release") {
        resolve(clip, {"tool", "tool", "tools"}, tools_, path);
      }
      if (meets_body || clip.key == "move") resolve(clip, {"body", "body", "bodies", meets_body}, bodies_, path);
      if (clip.key == "inflate" || clip.key == "drain") {
        resolve(clip, {"body", "body", "bodies"}, bodies_, path);
        check_chamber(clip, path);
      }
    }
  }

  void check_orifices() {
    const CheckedValue* bodies = root_.find("bodies");
    if (bodies == nullptr) return;
    for (const CheckedMember& body : bodies->members) {
      const CheckedValue* contents = body.value.find("contents");
      const CheckedValue* orifices = contents == nullptr ? nullptr : contents->find("orifices");
      if (orifices == nullptr) continue;
      const std::string path = member_path("bodies", body.key) + ".contents";
      for (std::size_t index = 0; index < orifices->items.size(); ++index) {
        const CheckedValue* between = orifices->items[index].find("between");
        if (between == nullptr) continue;
        const std::string inner = item_path(path + ".orifices", index) + ".between";
        for (const CheckedValue& name : between->items) {
          check_name({name.text, name.location}, "chamber", names_in(*contents, "chambers"), inner, diagnostics_);
        }
        if (between->items[0].text == between->items[1].text) {
          diagnostics_.error(between->location, inner, "an orifice joins two different chambers");
        }
      }
    }
  }

  void check_looks() {
    const CheckedValue* look = root_.find("look");
    const CheckedValue* bodies = look == nullptr ? nullptr : look->find("bodies");
    if (bodies == nullptr) return;
    for (const CheckedMember& member : bodies->members) {
      check_name({member.key, member.location}, "body", bodies_.names, member_path("look.bodies", member.key),
                 diagnostics_);
    }
  }

  void check_meshes() {
    const CheckedValue* bodies = root_.find("bodies");
    if (bodies == nullptr) return;
    for (const CheckedMember& body : bodies->members) {
      const CheckedValue* surface = body.value.find("surface");
      const CheckedValue* mesh = surface == nullptr ? nullptr : surface->find("mesh");
      std::error_code failure;
      if (mesh == nullptr || std::filesystem::is_regular_file(mesh->text, failure)) continue;
      diagnostics_.error(mesh->location, member_path("bodies", body.key) + ".surface.mesh", no_file_words(mesh->text));
    }
  }

  void check_groups() {
    const CheckedValue* bodies = root_.find("bodies");
    if (bodies == nullptr) return;
    for (const CheckedMember& body : bodies->members) {
      const CheckedValue* surface = body.value.find("surface");
      const CheckedValue* shape = surface == nullptr ? nullptr : surface->find("shape");
      if (shape != nullptr) check_groups_in(body.value, *surface, member_path("bodies", body.key));
    }
  }

  void warn_of_unused_tools() {
    const CheckedValue* tools = root_.find("tools");
    if (tools == nullptr) return;
    for (const CheckedMember& tool : tools->members) {
      if (!used_.contains(tool.key)) {
        diagnostics_.warning(tool.location, member_path("tools", tool.key), "no clip uses this tool");
      }
    }
  }

 private:
  void check_chamber(const CheckedMember& clip, const std::string& path) {
    const CheckedValue* body = clip.value.find("body");
    const CheckedValue* chamber = clip.value.find("chamber");
    const CheckedValue* bodies = root_.find("bodies");
    if (body == nullptr || bodies == nullptr) return;
    const CheckedValue* named = bodies->find(body->text);
    const CheckedValue* contents = named == nullptr ? nullptr : named->find("contents");
    if (contents == nullptr) return;
    if (chamber == nullptr) {
      const std::vector<std::string> names = names_in(*contents, "chambers");
      if (names.size() < 2 || clip.value.has_wrong("chamber")) return;
      diagnostics_.absence(clip.location, path, "`chamber` is missing; there is " + list_in_backticks(names));
      return;
    }
    check_name({chamber->text, chamber->location}, "chamber", names_in(*contents, "chambers"),
               member_path(path, "chamber"), diagnostics_);
  }

  /// Looks for groups everywhere below a body: the keys of regions are the only ones of that name.
  void check_groups_in(const CheckedValue& value, const CheckedValue& surface, const std::string& path) {
    for (std::size_t index = 0; index < value.items.size(); ++index) {
      check_groups_in(value.items[index], surface, item_path(path, index));
    }
    for (const CheckedMember& member : value.members) {
      const std::string inner = member_path(path, member.key);
      check_groups_in(member.value, surface, inner);
      const std::vector<std::string> groups = groups_of_shape(surface);
      if (member.key != "group" || std::ranges::find(groups, member.value.text) != groups.end()) continue;
      diagnostics_.error(member.value.location, inner,
                         "the shape " + in_backticks(surface.at("shape").text) + " has no group " +
                             in_backticks(member.value.text) + "; it has " + list_in_backticks(groups));
    }
  }

  void resolve(CheckedMember& clip, const Reference& reference, const NameChoice& choice, const std::string& path) {
    if (clip.value.has_wrong(reference.key) || root_.find(reference.section) == nullptr) return;
    if (const CheckedValue* named = clip.value.find(reference.key)) {
      check_name({named->text, named->location}, reference.what, choice.names, member_path(path, reference.key),
                 diagnostics_);
      if (reference.key == "tool") used_.insert(named->text);
      return;
    }
    if (!choice.meant.empty()) {
      const CheckedValue only{
          .kind = CheckedKind::kText, .location = clip.location, .given = false, .text = choice.meant};
      const std::size_t position = reference.key == "body" && clip.value.find("tool") != nullptr ? 1 : 0;
      clip.value.members.insert(clip.value.members.begin() + static_cast<std::ptrdiff_t>(position),
                                {reference.key, clip.location, only});
      if (reference.key == "tool") used_.insert(choice.meant);
    } else if (reference.needed && choice.names.empty()) {
      diagnostics_.error(clip.location, path,
                         "needs a " + reference.what + ", but " + in_backticks(reference.section) + " is empty");
    } else if (reference.needed) {
      diagnostics_.absence(clip.location, path,
                           in_backticks(reference.key) + " is missing; there is " + list_in_backticks(choice.names));
    }
  }

  CheckedValue& root_;
  Diagnostics& diagnostics_;
  NameChoice tools_;
  NameChoice bodies_;
  std::set<std::string> used_;
};

}  // namespace

void reference_pass(CheckedValue& root, Diagnostics& diagnostics) {
  ReferenceChecker checker(root, diagnostics);
  checker.check_clips();
  checker.check_orifices();
  checker.check_looks();
  checker.check_meshes();
  checker.check_groups();
  checker.warn_of_unused_tools();
}

}  // namespace thinwall
