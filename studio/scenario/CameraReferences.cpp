#include "studio/scenario/CameraReferences.hpp"

#include <algorithm>

#include "studio/scenario/NameCheck.hpp"
#include "studio/scenario/TextNode.hpp"

namespace thinwall {
namespace {

/// Each item of a list is later than the one before.
void check_order(const CheckedValue& list, const std::string& path, Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < list.items.size(); ++i) {
    const CheckedValue* before = list.items[i - 1].find("at");
    const CheckedValue* time = list.items[i].find("at");
    if (before == nullptr || time == nullptr || time->number > before->number) continue;
    diagnostics.error(time->location, item_path(path, i) + ".at", "must be later than the one before it");
  }
}

void check_keyframes(const CheckedValue& camera, const std::string& path, Diagnostics& diagnostics) {
  const CheckedValue* keyframes = camera.find("keyframes");
  if (keyframes == nullptr) return;
  check_order(*keyframes, path + ".keyframes", diagnostics);
  // One that follows a tool looks at that.
  if (camera.find("follow") != nullptr) return;
  const auto same = [](const CheckedValue& a, const CheckedValue& b) {
    return std::ranges::equal(a.items, b.items, {}, &CheckedValue::number, &CheckedValue::number);
  };
  for (std::size_t i = 0; i < keyframes->items.size(); ++i) {
    const CheckedValue& keyframe = keyframes->items[i];
    const CheckedValue *position = keyframe.find("position"), *target = keyframe.find("target");
    const CheckedValue* written = target != nullptr ? target : position;
    if (written == nullptr) continue;
    // What a keyframe leaves out is the camera's own.
    if (position == nullptr) position = camera.find("position");
    if (target == nullptr) target = camera.find("target");
    if (position == nullptr || target == nullptr || !same(*position, *target)) continue;
    const std::string key = written == target ? ".target" : ".position";
    diagnostics.error(written->location, item_path(path + ".keyframes", i) + key, "the camera stands where it looks");
  }
}

void check_push_ins(const CheckedValue& camera, const std::string& path, Diagnostics& diagnostics) {
  const CheckedValue* push_ins = camera.find("push_in");
  if (push_ins == nullptr) return;
  for (std::size_t i = 0; i < push_ins->items.size(); ++i) {
    const CheckedValue* from = push_ins->items[i].find("from");
    const CheckedValue* until = push_ins->items[i].find("until");
    if (from == nullptr || until == nullptr || until->number > from->number) continue;
    diagnostics.error(until->location, item_path(path + ".push_in", i) + ".until", "must be later than `from`");
  }
}

void check_camera(CheckedValue& camera, const NameChoice& tools, const std::string& path, Diagnostics& diagnostics) {
  check_keyframes(camera, path, diagnostics);
  check_push_ins(camera, path, diagnostics);
  CheckedValue* follow = camera.find("follow");
  if (follow != nullptr) resolve_name(*follow, "tool", tools, path + ".follow", diagnostics);
}

void check_cuts(const CheckedValue& cuts, std::vector<std::string> cameras, Diagnostics& diagnostics) {
  std::erase(cameras, "main");
  cameras.insert(cameras.begin(), "main");
  check_order(cuts, "cuts", diagnostics);
  for (std::size_t i = 0; i < cuts.items.size(); ++i) {
    for (const char* key : {"camera", "beside", "inset"}) {
      const CheckedValue* name = cuts.items[i].find(key);
      if (name == nullptr) continue;
      check_name({name->text, name->location}, "camera", cameras, item_path("cuts", i) + "." + key, diagnostics);
    }
  }
}

}  // namespace

void camera_references(CheckedValue& root, Diagnostics& diagnostics) {
  const NameChoice tools = choice_of(names_in(root, "tools"));
  if (CheckedValue* camera = root.find("camera")) check_camera(*camera, tools, "camera", diagnostics);
  if (CheckedValue* cameras = root.find("cameras")) {
    for (CheckedMember& member : cameras->members) {
      const std::string path = member_path("cameras", member.key);
      if (member.key == "main") diagnostics.error(member.location, path, "`main` is the name of `camera`");
      check_camera(member.value, tools, path, diagnostics);
    }
  }
  if (const CheckedValue* cuts = root.find("cuts")) check_cuts(*cuts, names_in(root, "cameras"), diagnostics);
}

}  // namespace thinwall
