#include "studio/scenario/ClipBuilder.hpp"

#include "studio/scenario/CheckedReading.hpp"

namespace thinwall {
namespace {

PalpateClip to_palpate(const CheckedValue& clip) {
  return {.tool = clip.at("tool").text,
          .body = clip.at("body").text,
          .at = to_vector(clip.at("at")),
          .direction = to_vector(clip.at("direction")),
          .axis = find_vector(clip, "axis"),
          .depth = clip.at("depth").number,
          .speed = clip.at("speed").number,
          .hold = clip.at("hold").number,
          .standoff = clip.at("standoff").number,
          .withdraw = clip.at("withdraw").boolean};
}

InciseClip to_incise(const CheckedValue& clip) {
  InciseClip incise{.tool = clip.at("tool").text,
                    .body = clip.at("body").text,
                    .direction = find_vector(clip, "direction"),
                    .reach = clip.at("reach").number,
                    .depth = clip.at("depth").number,
                    .speed = clip.at("speed").number,
                    .hold = clip.at("hold").number,
                    .standoff = clip.at("standoff").number,
                    .withdraw = clip.at("withdraw").boolean,
                    .marked = clip.at("marked").boolean};
  for (const CheckedValue& point : clip.at("path").items) {
    incise.path.push_back(to_vector(point));
    incise.path_locations.push_back(point.location);
  }
  return incise;
}

MoveClip to_move(const CheckedValue& clip) {
  return {.tool = clip.at("tool").text,
          .body = find_text(clip, "body"),
          .from = find_vector(clip, "from"),
          .to = find_vector(clip, "to").value_or(Eigen::Vector3d::Zero()),
          .by = find_vector(clip, "by"),
          .direction = find_vector(clip, "direction"),
          .axis = find_vector(clip, "axis"),
          .duration = clip.at("for").number,
          .ease = clip.at("ease").text == "linear" ? Ease::kLinear : Ease::kSmooth};
}

GraspClip to_grasp(const CheckedValue& clip) {
  return {.tool = clip.at("tool").text,
          .body = clip.at("body").text,
          .at = to_vector(clip.at("at")),
          .direction = to_vector(clip.at("direction")),
          .axis = find_vector(clip, "axis"),
          .depth = clip.at("depth").number,
          .speed = clip.at("speed").number,
          .standoff = clip.at("standoff").number,
          .to = clip.at("to").number,
          .grip = find_number(clip, "grip").value_or(0),
          .duration = clip.at("for").number};
}

FillClip to_fill(const CheckedValue& clip, double sense) {
  return {.body = clip.at("body").text,
          .chamber = find_text(clip, "chamber"),
          .added = sense * find_number(clip, "by").value_or(0),
          .pressure = find_number(clip, "to"),
          .drains = sense < 0,
          .duration = clip.at("for").number};
}

}  // namespace

Clip to_clip(const CheckedValue& item) {
  const CheckedMember& action = item.members[0];
  Clip clip{.action = WaitClip{}, .location = action.location};
  if (action.key == "palpate") clip.action = to_palpate(action.value);
  if (action.key == "pierce") clip.action = PierceClip{to_palpate(action.value)};
  if (action.key == "incise") clip.action = to_incise(action.value);
  if (action.key == "move") clip.action = to_move(action.value);
  if (action.key == "grasp") clip.action = to_grasp(action.value);
  if (action.key == "release") {
    clip.action = ReleaseClip{.tool = action.value.at("tool").text, .duration = action.value.at("for").number};
  }
  if (action.key == "inflate") clip.action = to_fill(action.value, 1);
  if (action.key == "drain") clip.action = to_fill(action.value, -1);
  if (action.key == "wait") clip.action = WaitClip{action.value.at("for").number};
  clip.start = find_number(action.value, "start");
  clip.caption = find_text(action.value, "caption");
  clip.chapter = find_text(action.value, "chapter");
  return clip;
}

}  // namespace thinwall
