#include "studio/director/Schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "studio/scenario/ClipTimes.hpp"
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

/// When a blade may be in its body, seconds.
struct TimeInBody {
  double from = 0;
  double until = 0;
};

/// A blade that does not go out stays in its body until another clip drives it.
TimeInBody time_in_body(const IncisionPlan& incision, std::size_t index, std::span<const Clip> timeline,
                        std::span<const ScheduledClip> clips) {
  const ScheduledClip& clip = clips[index];
  TimeInBody time{.from = clip.begin + incision.to_contact / incision.clip.speed, .until = clip.end};
  if (incision.clip.withdraw) return time;
  time.until = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < clips.size(); ++k) {
    const bool is_later = k != index && clips[k].begin >= clip.end - kTimeTolerance;
    if (is_later && tool_of(timeline[k]) == incision.clip.tool) time.until = std::min(time.until, clips[k].begin);
  }
  return time;
}

/// A body has one cut at a time that a blade is in.
void refuse_second_blades(std::span<const Clip> timeline, std::span<const ScheduledClip> clips) {
  for (std::size_t k = 0; k < clips.size(); ++k) {
    const auto* first = std::get_if<IncisionPlan>(&clips[k].plan);
    if (first == nullptr) continue;
    const TimeInBody in = time_in_body(*first, k, timeline, clips);
    for (std::size_t other = 0; other < clips.size(); ++other) {
      const auto* second = std::get_if<IncisionPlan>(&clips[other].plan);
      if (second == nullptr || second->clip.body != first->clip.body || second->clip.tool == first->clip.tool) continue;
      const bool is_later = clips[other].begin > clips[k].begin || (clips[other].begin == clips[k].begin && other > k);
      if (!is_later || clips[other].begin >= in.until - kTimeTolerance) continue;
      if (time_in_body(*second, other, timeline, clips).until <= in.from) continue;
      throw InputErrors(
          {{timeline[other].location,
            fmt::format("timeline[{}].incise: blade `{}` begins at {:.4g} s to cut body `{}`, which blade `{}` cuts "
                        "{}; let that go out (`withdraw`) before this begins",
                        other + 1, second->clip.tool, clips[other].begin, first->clip.body, first->clip.tool,
                        std::isfinite(in.until) ? fmt::format("until {:.4g} s", in.until) : "and then stays in")}});
    }
  }
}

/// What is shown while a clip lasts: its own words, or what it does where no other clip has words for that time.
std::string caption_of(std::span<const Clip> timeline, std::span<const ScheduledClip> clips, std::size_t index) {
  if (timeline[index].caption) return *timeline[index].caption;
  for (std::size_t k = 0; k < clips.size(); ++k) {
    const bool is_meanwhile =
        clips[k].begin < clips[index].end - kTimeTolerance && clips[index].begin < clips[k].end - kTimeTolerance;
    if (is_meanwhile && !timeline[k].caption.value_or("").empty()) return "";
  }
  return standard_caption(timeline[index]);
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
  refuse_second_blades(timeline, clips);
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

void refuse_endless(std::span<const Clip> timeline, std::span<const ScheduledClip> clips, double time_step) {
  const auto longest = std::ranges::max_element(clips, {}, &ScheduledClip::end);
  if (longest == clips.end() || longest->end / time_step <= kMostSteps) return;
  const auto k = static_cast<std::size_t>(longest - clips.begin());
  throw InputErrors(
      {{timeline[k].location,
        fmt::format(
            "timeline[{}]: the run would take {:.4g} steps, 10 million are allowed; let the clip end sooner: give "
            "it a higher `speed`, a shorter way or a smaller `standoff`, or take a longer `time_step`",
            k + 1, longest->end / time_step)}});
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
      clips[k].plan = plan_clip(timeline[k], {.definition = {}, .pose = left.at(tool), .is_first = false}, {});
    }
    left[tool] = moment_of(clips[k].plan, duration_of(clips[k].plan))->pose;
  }
}

std::map<std::string, std::size_t> driving_clips(std::span<const Clip> timeline, std::span<const ScheduledClip> clips,
                                                 double from, double until) {
  std::map<std::string, std::size_t> driving;
  for (std::size_t k = 0; k < clips.size(); ++k) {
    if (!clips[k].begun || clips[k].end <= from + kTimeTolerance) continue;
    if (!moment_of(clips[k].plan, until - clips[k].begin)) continue;
    const auto [last, is_first] = driving.try_emplace(tool_of(timeline[k]), k);
    if (!is_first && clips[k].begin >= clips[last->second].begin) last->second = k;
  }
  return driving;
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
    const std::string text = chapters ? timeline[k].chapter.value_or("") : caption_of(timeline, clips, k);
    if (!text.empty()) result.push_back({.begin = clips[k].begin, .end = clips[k].end, .text = text});
  }
  std::ranges::stable_sort(result, {}, &TimedText::begin);
  return result;
}

}  // namespace thinwall
