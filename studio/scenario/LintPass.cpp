#include "studio/scenario/LintPass.hpp"

#include <algorithm>
#include <optional>

#include "studio/scenario/CameraLint.hpp"
#include "studio/scenario/CheckedReading.hpp"
#include "studio/scenario/ClipTimes.hpp"
#include "studio/scenario/CutLint.hpp"
#include "studio/scenario/FieldLint.hpp"
#include "studio/scenario/GraspLint.hpp"
#include "studio/scenario/MaterialLint.hpp"
#include "studio/scenario/Parallel.hpp"
#include "studio/scenario/StepLint.hpp"
#include "studio/scenario/TextNode.hpp"
#include "studio/schema/Quantity.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

void check_shape(const CheckedMember& body, const std::string& path, Diagnostics& diagnostics) {
  const CheckedValue* surface = body.value.find("surface");
  const CheckedValue* shape = surface == nullptr ? nullptr : surface->find("shape");
  if (shape == nullptr) return;
  const CheckedValue* radius = surface->find("radius");
  const CheckedValue* hole = surface->find("inner_radius");
  if (radius != nullptr && hole != nullptr && hole->number >= radius->number) {
    diagnostics.error(hole->location, path + ".surface.inner_radius", "the hole must be smaller than `radius`");
  }
  const CheckedValue* contents = body.value.find("contents");
  const CheckedValue* fluid = contents == nullptr ? nullptr : contents->find("fluid");
  const std::string& word = shape->text;
  const bool is_open = word == "sheet" || word == "disc" || word == "annulus" || word == "strip";
  if (is_open && fluid != nullptr && fluid->text != "none") {
    diagnostics.error(
        fluid->given ? fluid->location : shape->location, path + ".contents",
        "the shape " + in_backticks(word) + " is open and holds no fluid; write `contents: { fluid: none }`");
  }
}

void check_viscosity(const CheckedMember& body, const std::string& path, Diagnostics& diagnostics) {
  const CheckedValue* wall = body.value.find("wall");
  const CheckedValue* viscosity = wall == nullptr ? nullptr : wall->find("viscosity");
  if (viscosity == nullptr) return;
  double sum = 0;
  for (const CheckedValue& term : viscosity->items) {
    const CheckedValue* fraction = term.find("fraction");
    sum += fraction == nullptr ? 0 : fraction->number;
  }
  if (sum >= 1) {
    diagnostics.error(viscosity->location, path + ".wall.viscosity",
                      "the fractions add up to " + format_like(sum, "0.5") + ", but something must last: below 1");
  }
}

void check_loads(const CheckedMember& body, const std::string& path, Diagnostics& diagnostics) {
  const CheckedValue* loads = body.value.find("loads");
  const CheckedValue* wall = body.value.find("wall");
  const CheckedValue* model = wall == nullptr ? nullptr : wall->find("model");
  for (std::size_t index = 0; loads != nullptr && index < loads->items.size(); ++index) {
    const CheckedValue& load = loads->items[index];
    const std::string inner = item_path(path + ".loads", index);
    const CheckedValue* over = load.find("over");
    for (std::size_t k = 1; over != nullptr && k < over->items.size(); ++k) {
      if (over->items[k].items[0].number > over->items[k - 1].items[0].number) continue;
      diagnostics.error(over->items[k].location, item_path(inner + ".over", k), "the times must increase");
    }
    const CheckedValue* moment = load.find("moment");
    if (moment != nullptr && model != nullptr && model->text == "membrane") {
      diagnostics.error(moment->location, inner + ".moment",
                        "a membrane bears no moment; write `model: shell` in the wall, or a force");
    }
  }
}

/// How far, or where to.
void check_goal(const CheckedMember& clip, const std::string& path, Diagnostics& diagnostics) {
  if (clip.key != "inflate" && clip.key != "drain" && clip.key != "move") return;
  const CheckedValue *by = clip.value.find("by"), *to = clip.value.find("to");
  if (by != nullptr && to != nullptr) {
    diagnostics.error(to->location, path + ".to", "`by` and `to` exclude each other");
  } else if (by == nullptr && to == nullptr && !clip.value.has_wrong("by") && !clip.value.has_wrong("to")) {
    diagnostics.error(clip.location, path, "one of `by`, `to` is missing");
  }
}

/// A bare point holds what it touches: it cannot slide.
void check_point_friction(const CheckedMember& tool, Diagnostics& diagnostics) {
  const CheckedValue *kind = tool.value.find("kind"), *friction = tool.value.find("friction");
  if (kind == nullptr || kind->text != "point" || friction == nullptr) return;
  if (tool.value.find("radius") != nullptr || tool.value.has_wrong("radius")) return;
  diagnostics.error(friction->location, member_path("tools", tool.key) + ".friction",
                    "a bare point holds what it touches and does not slide; give it a `radius`");
}

/// A membrane gives way to a bare point without end, so that the force is the mesh's.
void check_bare_point(const CheckedValue& root, const CheckedMember& clip, const std::string& path,
                      Diagnostics& diagnostics) {
  const CheckedValue *named_tool = clip.value.find("tool"), *named_body = clip.value.find("body");
  const CheckedValue *tools = root.find("tools"), *bodies = root.find("bodies");
  if (named_tool == nullptr || named_body == nullptr || tools == nullptr || bodies == nullptr) return;
  const CheckedValue *tool = tools->find(named_tool->text), *body = bodies->find(named_body->text);
  if (tool == nullptr || body == nullptr || tool->find("radius") != nullptr) return;
  const CheckedValue *kind = tool->find("kind"), *wall = body->find("wall");
  const CheckedValue* model = wall == nullptr ? nullptr : wall->find("model");
  if (kind == nullptr || kind->text != "point" || model == nullptr || model->text != "membrane") return;
  diagnostics.warning(clip.location, path,
                      "the force of a bare point on a membrane falls with every refinement of the mesh; give " +
                          in_backticks(named_tool->text) + " a `radius` for one that does not");
}

void check_boxes(const CheckedValue& value, const std::string& path, Diagnostics& diagnostics) {
  for (std::size_t index = 0; index < value.items.size(); ++index) {
    check_boxes(value.items[index], item_path(path, index), diagnostics);
  }
  for (const CheckedMember& member : value.members) {
    const std::string inner = member_path(path, member.key);
    check_boxes(member.value, inner, diagnostics);
    const auto low = find_vector(member.value, "min");
    const auto high = find_vector(member.value, "max");
    if (member.key == "box" && low && high && (low->array() > high->array()).any()) {
      diagnostics.error(member.location, inner, "a component of `min` is larger than that of `max`");
    }
  }
}

bool is_endoscope(const CheckedValue& root) {
  const CheckedValue* camera = root.find("camera");
  const CheckedValue* kind = camera == nullptr ? nullptr : camera->find("kind");
  return kind != nullptr && kind->text == "endoscope";
}

/// Inside a body there is no other light than the endoscope's.
void check_lights(const CheckedValue& root, Diagnostics& diagnostics) {
  const CheckedValue* lights = root.find("lights");
  if (lights == nullptr) return;
  const CheckedValue* endoscope = lights->find("endoscope");
  if (endoscope == nullptr ? !is_endoscope(root) : endoscope->number <= 0) return;
  for (const char* key : {"key", "fill", "key_direction"}) {
    const CheckedValue* other = lights->find(key);
    if (other == nullptr || !other->given) continue;
    diagnostics.error(other->location, member_path("lights", key),
                      "does not shine beside the lamp of an endoscope; leave it out, or set `lights.endoscope` to 0");
  }
}

/// `is_first`: whether no earlier clip has given the tool an attitude, which a move would keep.
void check_frame(const CheckedMember& clip, const std::string& path, bool is_first, Diagnostics& diagnostics) {
  const CheckedValue& values = clip.value;
  auto direction = find_vector(values, "direction");
  const auto from = find_vector(values, "from");
  const auto to = find_vector(values, "to"), by = find_vector(values, "by");
  if (clip.key == "move" && is_first && !direction && !values.has_wrong("direction") && (by || (from && to))) {
    const Eigen::Vector3d way = by ? *by : *to - *from;
    if (way.isZero(0)) {
      diagnostics.error(
          clip.location, path,
          std::string("`direction` is missing: ") + (by ? "`by` leads nowhere" : "`from` and `to` are the same point"));
      return;
    }
    direction = way.normalized();
  }
  const auto axis = find_vector(values, "axis");
  if (axis && direction && are_parallel(*axis, *direction)) {
    diagnostics.error(values.find("axis")->location, path + ".axis", "the axis lies along the direction");
  }
}

void check_overlaps(const std::vector<ClipTimes>& clips, Diagnostics& diagnostics) {
  for (std::size_t later = 0; later < clips.size(); ++later) {
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const ClipTimes& a = clips[earlier];
      const ClipTimes& b = clips[later];
      if (a.tool.empty() || a.tool != b.tool || !certainly_overlap(a, b)) continue;
      diagnostics.error(b.location, b.path,
                        "drives " + in_backticks(a.tool) + " while " + a.path + " in line " +
                            std::to_string(a.location.line) + " still does");
    }
  }
}

void check_goldens(const CheckedValue& root, const std::vector<ClipTimes>& clips, Diagnostics& diagnostics) {
  const CheckedValue* goldens = root.find("golden");
  if (goldens == nullptr) return;
  const std::optional<double> end = end_of_timeline(clips);
  std::vector<double> times;
  int videos = 0;
  for (std::size_t index = 0; index < goldens->items.size(); ++index) {
    if (const CheckedValue* video = goldens->items[index].find("video"); video != nullptr && ++videos > 1) {
      diagnostics.error(video->location, item_path("golden", index) + ".video",
                        "there is a golden of the video already");
    }
    const CheckedValue* at = goldens->items[index].find("at");
    if (at == nullptr) continue;
    const std::string path = item_path("golden", index) + ".at";
    if (end && at->number > *end) {
      diagnostics.error(at->location, path, "the timeline ends at " + format_like(*end, "1 s"));
    }
    if (std::ranges::find(times, at->number) != times.end()) {
      diagnostics.error(at->location, path, "there is a golden at this time already");
    }
    times.push_back(at->number);
  }
}

/// Seconds; a step below this is what is at fault, otherwise it is the clip.
constexpr double kShortStep = 1e-6;

void check_step_count(const CheckedValue& root, const std::vector<ClipTimes>& clips, Diagnostics& diagnostics) {
  const CheckedValue* simulation = root.find("simulation");
  const CheckedValue* step = simulation == nullptr ? nullptr : simulation->find("time_step");
  if (step == nullptr || !(step->number > 0)) return;
  const auto longest = std::ranges::max_element(
      clips, {}, [](const ClipTimes& clip) { return clip.start.value_or(0) + clip.shortest_duration; });
  if (longest == clips.end()) return;
  const double seconds = longest->start.value_or(0) + longest->shortest_duration, steps = seconds / step->number;
  if (steps <= kMostSteps) return;
  const bool is_short = step->given && step->number < kShortStep;
  diagnostics.error(is_short ? step->location : longest->location, is_short ? "simulation.time_step" : longest->path,
                    "the run would take " + format_like(steps, "1") + " steps or more, 10 million are allowed; " +
                        (is_short ? "take a longer `time_step`" : "let the clip end sooner"));
}

/// A golden of the video needs one.
void check_golden_video(const CheckedValue& root, Diagnostics& diagnostics) {
  const CheckedValue* goldens = root.find("golden");
  const CheckedValue* record = root.find("record");
  const CheckedValue* is_wanted = record == nullptr ? nullptr : record->find("video");
  if (goldens == nullptr || is_wanted == nullptr || is_wanted->boolean) return;
  for (std::size_t index = 0; index < goldens->items.size(); ++index) {
    const CheckedValue* video = goldens->items[index].find("video");
    if (video == nullptr) continue;
    diagnostics.error(video->location, item_path("golden", index) + ".video", "`record.video` says that there is none");
  }
}

/// What excuses pixels says nothing without the fraction of those that may fail.
void check_golden_excuses(const CheckedValue& root, Diagnostics& diagnostics) {
  const CheckedValue* goldens = root.find("golden");
  if (goldens == nullptr) return;
  for (std::size_t index = 0; index < goldens->items.size(); ++index) {
    if (goldens->items[index].find("failing") != nullptr) continue;
    for (const char* key : {"level", "shift"}) {
      const CheckedValue* excuse = goldens->items[index].find(key);
      if (excuse == nullptr || excuse->number == 0) continue;
      diagnostics.error(excuse->location, item_path("golden", index) + "." + key, "is of no use without `failing`");
    }
  }
}

void check_data_view(const CheckedValue& root, Diagnostics& diagnostics) {
  const CheckedValue* look = root.find("look");
  const CheckedValue* data = look == nullptr ? nullptr : look->find("data");
  if (data == nullptr) return;
  const CheckedValue* teaching = root.find("teaching");
  const CheckedValue* highlights = teaching == nullptr ? nullptr : teaching->find("highlights");
  if (highlights != nullptr && !highlights->items.empty()) {
    diagnostics.warning(
        highlights->location, "teaching.highlights",
        "are not drawn with `look.data`, where the wall's colours are its numbers; labels and arrows are");
  }
  const CheckedValue *from = data->find("from"), *to = data->find("to");
  if (from != nullptr && to != nullptr && from->number >= to->number) {
    diagnostics.error(to->location, "look.data.to", "must be more than `from`");
  }
  const CheckedValue* goldens = root.find("golden");
  if (goldens != nullptr && !goldens->items.empty() && (from == nullptr || to == nullptr)) {
    diagnostics.error(data->location, "look.data", "goldens need both ends of the colours: give `from` and `to`");
  } else if (from == nullptr || to == nullptr) {
    diagnostics.warning(data->location, "look.data",
                        "`run` and `still` draw no picture without both ends of the colours: give `from` and `to`, or "
                        "record with `run --no-render` and draw with `render`, which takes them from the whole take");
  }
}

}  // namespace

void lint_pass(const CheckedValue& root, Diagnostics& diagnostics) {
  if (const CheckedValue* bodies = root.find("bodies")) {
    for (const CheckedMember& body : bodies->members) {
      const std::string path = member_path("bodies", body.key);
      check_shape(body, path, diagnostics);
      check_viscosity(body, path, diagnostics);
      check_loads(body, path, diagnostics);
      check_fields(body, path, diagnostics);
    }
    for (const CheckedMember& body : bodies->members) {
      check_material(body, member_path("bodies", body.key), diagnostics);
    }
    check_boxes(*bodies, "bodies", diagnostics);
  }
  check_data_view(root, diagnostics);
  check_cameras(root, diagnostics);
  check_lights(root, diagnostics);
  const CheckedValue* timeline = root.find("timeline");
  const std::vector<ClipTimes> clips = clip_times(root);
  for (std::size_t index = 0, clip = 0; timeline != nullptr && index < timeline->items.size(); ++index) {
    const CheckedValue& item = timeline->items[index];
    if (item.members.empty()) continue;
    const std::string path = member_path(item_path("timeline", index), item.members[0].key);
    check_frame(item.members[0], path, is_first_of_its_tool(clips, clip++), diagnostics);
    check_goal(item.members[0], path, diagnostics);
    if (item.members[0].key == "palpate") check_bare_point(root, item.members[0], path, diagnostics);
  }
  if (const CheckedValue* tools = root.find("tools")) {
    for (const CheckedMember& tool : tools->members) check_point_friction(tool, diagnostics);
  }
  check_grasps(root, diagnostics);
  check_cuts(root, diagnostics);
  check_overlaps(clips, diagnostics);
  check_step_count(root, clips, diagnostics);
  check_steps(root, diagnostics);
  check_goldens(root, clips, diagnostics);
  check_golden_excuses(root, diagnostics);
  check_golden_video(root, diagnostics);
}

}  // namespace thinwall
