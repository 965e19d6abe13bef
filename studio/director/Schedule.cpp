#include "studio/director/Schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

/// Two clips that drive one tool at once, the later one in the timeline first; nothing where there are none.
std::optional<std::pair<std::size_t, std::size_t>> first_overlap(std::span<const Clip> timeline,
                                                                 std::span<const ScheduledClip> clips) {
  for (std::size_t k = 0; k < clips.size(); ++k) {
    const std::string tool = tool_of(timeline[k]);
    for (std::size_t other = 0; other < k && !tool.empty(); ++other) {
      const bool is_apart =
          clips[k].begin >= clips[other].end - kTimeTolerance || clips[other].begin >= clips[k].end - kTimeTolerance;
      if (tool == tool_of(timeline[other]) && !is_apart) return std::pair(k, other);
    }
  }
  return std::nullopt;
}

}  // namespace

void schedule(std::span<const Clip> timeline, std::span<ScheduledClip> clips) {
  double previous_end = 0;
  for (std::size_t k = 0; k < clips.size(); ++k) {
    if (!clips[k].begun) clips[k].begin = timeline[k].start.value_or(previous_end);
    clips[k].end = clips[k].begin + duration_of(clips[k].plan);
    previous_end = clips[k].end;
  }
}

void refuse_overlaps(std::span<const Clip> timeline, std::span<const ScheduledClip> clips) {
  const auto overlap = first_overlap(timeline, clips);
  if (!overlap) return;
  const auto [k, other] = *overlap;
  throw InputErrors(
      {{timeline[k].location,
        fmt::format("timeline[{}]: drives tool `{}` from {:.4g} s to {:.4g} s, while timeline[{}] drives it from "
                    "{:.4g} s to {:.4g} s; start one after the other has ended",
                    k + 1, tool_of(timeline[k]), clips[k].begin, clips[k].end, other + 1, clips[other].begin,
                    clips[other].end)}});
}

void turn_at_step_end(std::span<const Clip> timeline, std::span<ScheduledClip> clips, std::size_t index,
                      double time_step) {
  PalpationPlan* pressing = pressing_of(clips[index].plan);
  if (pressing == nullptr) return;
  const double arrival = clips[index].begin + pressing->arrival();
  pressing->rest = std::max(0.0, std::ceil((arrival - kTimeTolerance) / time_step) * time_step - arrival);
  schedule(timeline, clips);
  if (!first_overlap(timeline, clips)) return;
  pressing->rest = 0;
  schedule(timeline, clips);
}

void foresee_moves(std::span<const Clip> timeline, std::span<ScheduledClip> clips) {
  std::vector<std::size_t> order(clips.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return clips[k].begin; });
  std::map<std::string, ToolPose> left;
  for (const std::size_t k : order) {
    const std::string tool = tool_of(timeline[k]);
    if (tool.empty()) continue;
    const auto* move = std::get_if<MoveClip>(&timeline[k].action);
    if (move != nullptr && left.contains(tool)) {
      clips[k].plan = plan_move(*move, left.at(tool), false, timeline[k].location);
    }
    left[tool] = moment_of(clips[k].plan, duration_of(clips[k].plan))->pose;
  }
}

double end_of(std::span<const ScheduledClip> clips) {
  double end = 0;
  for (const ScheduledClip& clip : clips) end = std::max(end, clip.end);
  return end;
}

std::vector<TimedText> texts_of(std::span<const Clip> timeline, std::span<const ScheduledClip> clips, bool chapters) {
  std::vector<TimedText> result;
  for (std::size_t k = 0; k < clips.size(); ++k) {
    // Those of time zero hold of the first moment already, though their clips begin with the step after it.
    if (!clips[k].begun && clips[k].begin > kTimeTolerance) continue;
    const Clip& clip = timeline[k];
    const std::string text = chapters ? clip.chapter.value_or("") : clip.caption.value_or(standard_caption(clip));
    if (!text.empty()) result.push_back({.begin = clips[k].begin, .end = clips[k].end, .text = text});
  }
  std::ranges::stable_sort(result, {}, &TimedText::begin);
  return result;
}

}  // namespace thinwall
