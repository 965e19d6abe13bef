#include "studio/recorder/FrameComposer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "renderer/snapshot/ActingSurfaces.hpp"
#include "renderer/snapshot/SameTime.hpp"
#include "renderer/snapshot/SurfaceFields.hpp"
#include "studio/recorder/ExpectedForce.hpp"

namespace thinwall {
namespace {

double magnitude(const Double3& vector) {
  return std::hypot(vector[0], vector[1], vector[2]);
}

constexpr const char* kIdle = "idle";

/// Whether a clip drives the tool and it touches.
bool works(const SnapshotTool& tool) {
  return tool.phase != kIdle && magnitude(tool.force) > 0;
}

bool is_in_picture(const SnapshotTool& tool) {
  return !tool.is_set_aside;
}

/// The text that holds at `time`: after its begin, up to and with its end. A run knows of a clip only once it has gone
/// beyond the clip's begin; with the begin included, a frame at that very time would differ between run and take. Only
/// at time zero there is no text before it, and a run knows what begins there.
std::string text_at(double time, const std::vector<TimedText>& texts) {
  std::string text;
  for (const TimedText& candidate : texts) {
    const bool has_begun = candidate.begin < std::max(time - kSameTime, kSameTime);
    if (has_begun && time <= candidate.end + kSameTime) text = candidate.text;
  }
  return text;
}

double squared_distance(const Double3& point, const SnapshotSurface& surface) {
  double least = std::numeric_limits<double>::infinity();
  for (const Float3& vertex : surface.positions) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) sum += std::pow(vertex[axis] - point[axis], 2);
    least = std::min(least, sum);
  }
  return least;
}

/// Of the body with contents that the tool is at, of the first one where there is no tool. An open sheet has no volume,
/// and the scenery that bodies lie in does not count.
void tell_pressure(const Snapshot& snapshot, const SnapshotTool* tool, OverlayContent& content) {
  content.pressure.reset();
  std::vector<const SnapshotSurface*> filled = acting_surfaces(snapshot);
  std::erase_if(filled, [&](const SnapshotSurface* surface) {
    return find_scalar(snapshot, surface->body, kVolumeScalar) == 0.0 ||
           !find_scalar(snapshot, surface->body, kPressureScalar);
  });
  if (filled.empty()) return;
  const SnapshotSurface* shown = filled.front();
  if (tool != nullptr && filled.size() > 1) {
    shown = *std::ranges::min_element(
        filled, {}, [&](const SnapshotSurface* surface) { return squared_distance(tool->tip, *surface); });
  }
  content.pressure = find_scalar(snapshot, shown->body, kPressureScalar);
  const auto is_other = [&](const SnapshotSurface* surface) { return surface->body != shown->body; };
  if (std::ranges::any_of(filled, is_other)) content.pressurized_body = shown->body;
}

std::optional<Legend> legend_of(const LookDefinition& look) {
  if (!look.data || !look.data->from || !look.data->to) return std::nullopt;
  const DataQuantityRow& row = row_of(look.data->quantity);
  return Legend{.title = std::string(row.title),
                .unit = std::string(row.unit),
                .from = *look.data->from,
                .to = *look.data->to,
                .scale = look.data->scale,
                .goes_on_below = look.data->goes_on_below,
                .goes_on_above = look.data->goes_on_above};
}

}  // namespace

FrameComposer::FrameComposer(std::string title, const OverlayChoice& choice, const ViewDefinition& view,
                             const AnnotationDefinition& annotations, PlannedPicture planned)
    : title_(std::move(title)),
      choice_(choice),
      legend_(legend_of(view.look)),
      view_(view),
      planned_(std::move(planned)),
      shots_(view),
      annotations_(std::make_shared<const AnnotationDefinition>(annotations)),
      comparison_(view.comparison) {
  if (!comparison_) return;
  second_shots_.emplace(comparison_->second);
  second_legend_ = legend_of(comparison_->second.look);
}

std::optional<double> FrameComposer::last_time() const {
  return later_ ? std::optional(later_->snapshot.time) : std::nullopt;
}

void FrameComposer::add(Moment moment) {
  if (later_) {
    for (std::size_t i = 0; i < later_->snapshot.tools.size(); ++i) {
      const bool is_at_work = works(later_->snapshot.tools[i]);
      if (is_at_work || (later_->snapshot.tools[i].phase != kIdle && !has_worked_)) last_active_ = i;
      has_worked_ = has_worked_ || is_at_work;
    }
  }
  earlier_ = std::move(later_);
  later_ = std::move(moment);
  shots_.add(later_->snapshot);
  set_aside_.add(later_->snapshot);
  if (!earlier_) {
    expected_force_ = expected_force(later_->snapshot);
    choose_corners();
  }
  histories_.resize(later_->snapshot.tools.size());
  for (std::size_t i = 0; i < histories_.size(); ++i) {
    histories_[i].push_back({.time = later_->snapshot.time, .force = magnitude(later_->snapshot.tools[i].force)});
  }
  if (comparison_ && later_->second) add_second(*later_);
}

/// When nothing but the first moment is known, so that pictures of a run are those of its take.
void FrameComposer::choose_corners() {
  OverlayContent legends;
  tell_halves(legends);
  corners_.emplace(CornerQuestion{.first = later_->snapshot,
                                  .view = view_,
                                  .annotations = *annotations_,
                                  .work = planned_.work,
                                  .size = planned_.size,
                                  .end = later_->planned_duration,
                                  .legends = legends});
  for (auto* legend : {&legend_, &second_legend_}) {
    if (*legend) (*legend)->corner = corners_->legend();
  }
}

void FrameComposer::tell_halves(OverlayContent& content) const {
  content.legend = legend_;
  if (comparison_) content.half_captions = comparison_->captions;
  if (!comparison_ || second_legend_ == legend_) return;
  content.left_legend = legend_;
  content.legend = second_legend_;
  content.legend_is_of_the_right = true;
}

void FrameComposer::add_second(const Moment& moment) {
  const Snapshot& second = moment.second->snapshot;
  second_shots_->add(second);
  second_set_aside_.add(second);
  second_histories_.resize(second.tools.size());
  for (std::size_t i = 0; i < second_histories_.size(); ++i) {
    // A take that has ended before the first has no more force to tell.
    if (second.time < moment.snapshot.time - kSameTime) continue;
    second_histories_[i].push_back({.time = second.time, .force = magnitude(second.tools[i].force)});
  }
}

/// The right half's snapshot, camera and light, and the force there.
void FrameComposer::compose_second(double time, const Moment& earlier, Frame& frame) const {
  const Snapshot& after = later_->second->snapshot;
  const Snapshot& before = earlier.second ? earlier.second->snapshot : after;
  Snapshot second = interpolate(before, after, time);
  second_set_aside_.mark(second);
  frame.shot.beside = second_shots_->shot(second, later_->planned_duration).camera;
  frame.shot.beside_snapshot = std::make_shared<const Snapshot>(std::move(second));
  frame.shot.beside_view = {comparison_, &comparison_->second};
  tell_halves(frame.overlay);
  const SnapshotTool* tool = shown_tool(frame.snapshot);
  if (tool == nullptr) return;
  const auto index = static_cast<std::size_t>(tool - frame.snapshot.tools.data());
  if (index >= second_histories_.size()) return;
  for (const ForceSample& sample : second_histories_[index]) {
    if (sample.time < time + kSameTime) frame.overlay.other_history.push_back(sample);
  }
}

bool FrameComposer::reaches(double time) const {
  return later_ && time <= later_->snapshot.time + kSameTime;
}

Frame FrameComposer::compose(double time) const {
  assert(reaches(time));
  const Moment& earlier = earlier_ ? *earlier_ : *later_;
  Frame frame{.snapshot = interpolate(earlier.snapshot, later_->snapshot, time), .overlay = {}};
  set_aside_.mark(frame.snapshot);
  frame.overlay = overlay(frame.snapshot);
  frame.shot = shots_.shot(frame.snapshot, later_->planned_duration);
  frame.shot.corner = corners_->inset(time).value_or(frame.shot.corner);
  frame.annotations = annotations_;
  if (comparison_ && later_->second) compose_second(time, earlier, frame);
  return frame;
}

OverlayContent FrameComposer::overlay(const Snapshot& snapshot) const {
  OverlayContent content;
  content.time = snapshot.time;
  content.duration = later_->planned_duration;
  content.title = title_;
  content.caption = text_at(snapshot.time, later_->captions);
  content.shown = choice_;
  content.legend = legend_;
  content.badges_to_come = planned_.badges;
  const SnapshotTool* tool = shown_tool(snapshot);
  tell_pressure(snapshot, tool, content);
  if (tool == nullptr) {
    content.shown.force_plot = content.shown.gauge = false;
    return content;
  }
  content.tool = tool->name;
  content.phase = tool->phase;
  content.force = magnitude(tool->force);
  content.expected_force = expected_force_;
  content.depth = tool->depth;
  content.tool_number = static_cast<std::size_t>(tool - snapshot.tools.data());
  content.history = history_of(content.tool_number, snapshot);
  for (std::size_t i = 0; i < snapshot.tools.size(); ++i) {
    if (i == content.tool_number) continue;
    std::vector<ForceSample> samples = history_of(i, snapshot);
    const bool has_touched = std::ranges::any_of(samples, [](const ForceSample& sample) { return sample.force > 0; });
    if (has_touched) content.other_tools.push_back({snapshot.tools[i].name, i, std::move(samples)});
  }
  return content;
}

std::vector<ForceSample> FrameComposer::history_of(std::size_t tool, const Snapshot& snapshot) const {
  std::vector<ForceSample> history;
  for (const ForceSample& sample : histories_[tool]) {
    if (sample.time < snapshot.time - kSameTime) history.push_back(sample);
  }
  history.push_back({.time = snapshot.time, .force = magnitude(snapshot.tools[tool].force)});
  return history;
}

const SnapshotTool* FrameComposer::last_to_set_out(const Snapshot& snapshot,
                                                   bool (*counts)(const SnapshotTool& tool)) const {
  const SnapshotTool* last = nullptr;
  double latest = 0;
  for (std::size_t i = 0; i < snapshot.tools.size(); ++i) {
    const double begun = set_aside_.begun(i, snapshot.time);
    if (!counts(snapshot.tools[i]) || (last != nullptr && begun <= latest)) continue;
    last = &snapshot.tools[i];
    latest = begun;
  }
  return last;
}

const SnapshotTool* FrameComposer::shown_tool(const Snapshot& snapshot) const {
  if (const SnapshotTool* working = last_to_set_out(snapshot, works)) return working;
  for (const SnapshotTool& tool : snapshot.tools) {
    if (tool.phase != kIdle && !has_worked_) return &tool;
  }
  if (last_active_ >= snapshot.tools.size()) return nullptr;
  if (!snapshot.tools[last_active_].is_set_aside) return &snapshot.tools[last_active_];
  return last_to_set_out(snapshot, is_in_picture);
}

}  // namespace thinwall
