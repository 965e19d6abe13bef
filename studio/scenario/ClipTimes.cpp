#include "studio/scenario/ClipTimes.hpp"

#include <algorithm>

#include "studio/scenario/TextNode.hpp"

namespace thinwall {
namespace {

double number_or_zero(const CheckedValue& mapping, std::string_view key) {
  const CheckedValue* value = mapping.find(key);
  return value == nullptr ? 0 : value->number;
}

/// Down and back at the given speed, and the hold between; the approach over the stand-off comes on top.
double shortest_palpation(const CheckedValue& clip) {
  const double speed = number_or_zero(clip, "speed");
  const CheckedValue* withdraw = clip.find("withdraw");
  const double ways = withdraw != nullptr && withdraw->boolean ? 2 : 1;
  const double travel = speed > 0 ? ways * number_or_zero(clip, "depth") / speed : 0;
  return travel + number_or_zero(clip, "hold");
}

/// Time in which the open jaws go from the stand-off to their depth.
double reach_of_grasp(const CheckedValue& clip) {
  const double speed = number_or_zero(clip, "speed");
  return speed > 0 ? (number_or_zero(clip, "standoff") + number_or_zero(clip, "depth")) / speed : 0;
}

/// The chamber that a clip fills or drains, as "body" or "body.chamber": two clips at once must not.
std::string filled_chamber(const CheckedValue& clip) {
  const CheckedValue *body = clip.find("body"), *chamber = clip.find("chamber");
  if (body == nullptr) return "";
  return chamber == nullptr ? body->text : body->text + "." + chamber->text;
}

}  // namespace

std::vector<ClipTimes> clip_times(const CheckedValue& root) {
  std::vector<ClipTimes> clips;
  const CheckedValue* timeline = root.find("timeline");
  if (timeline == nullptr) return clips;
  std::optional<double> end_of_last = 0.0;
  for (std::size_t index = 0; index < timeline->items.size(); ++index) {
    const CheckedValue& item = timeline->items[index];
    if (item.members.empty()) {
      end_of_last.reset();
      continue;
    }
    const CheckedMember& action = item.members[0];
    ClipTimes clip{.path = member_path(item_path("timeline", index), action.key), .location = action.location};
    if (const CheckedValue* tool = action.value.find("tool")) clip.tool = tool->text;
    if (action.key == "inflate" || action.key == "drain") clip.tool = filled_chamber(action.value);
    const CheckedValue* start = action.value.find("start");
    if (start != nullptr) {
      clip.start = start->number;
    } else if (!action.value.has_wrong("start")) {
      clip.start = end_of_last;
    }
    const CheckedValue* duration = action.value.find("for");
    clip.shortest_duration = duration != nullptr ? duration->number : shortest_palpation(action.value);
    if (action.key == "grasp") clip.shortest_duration += reach_of_grasp(action.value);
    if (clip.start && duration != nullptr) clip.end = *clip.start + clip.shortest_duration;
    end_of_last = clip.end;
    clips.push_back(std::move(clip));
  }
  return clips;
}

bool certainly_overlap(const ClipTimes& a, const ClipTimes& b) {
  if (!a.start || !b.start) return false;
  // Sums of decimal times meet only to rounding: a clip that starts when another ends does not overlap it.
  constexpr double kTolerance = 1e-9;  // seconds
  return *a.start < *b.start + b.shortest_duration - kTolerance &&
         *b.start < *a.start + a.shortest_duration - kTolerance;
}

bool is_first_of_its_tool(const std::vector<ClipTimes>& clips, std::size_t index) {
  const ClipTimes& clip = clips[index];
  for (std::size_t other = 0; other < clips.size(); ++other) {
    if (other == index || clips[other].tool != clip.tool) continue;
    const bool is_known = clip.start && clips[other].start;
    if (is_known ? *clips[other].start < *clip.start : other < index) return false;
  }
  return true;
}

std::optional<double> end_of_timeline(const std::vector<ClipTimes>& clips) {
  std::optional<double> end;
  for (const ClipTimes& clip : clips) {
    if (!clip.end) return std::nullopt;
    end = std::max(end.value_or(0), *clip.end);
  }
  return end;
}

}  // namespace thinwall
