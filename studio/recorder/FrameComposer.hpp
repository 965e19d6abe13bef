#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/annotation/Annotation.hpp"
#include "renderer/annotation/Card.hpp"
#include "renderer/overlay/Overlay.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "studio/record/Moment.hpp"
#include "studio/recorder/ClearCorners.hpp"
#include "studio/recorder/PlannedWork.hpp"
#include "studio/recorder/SetAsideTools.hpp"
#include "studio/recorder/ShotFollower.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// All that a frame is drawn from.
struct Frame {
  Snapshot snapshot;
  OverlayContent overlay;
  Shot shot = {};
  std::shared_ptr<const AnnotationDefinition> annotations = {};  // of the shot's own camera; null: none
  std::optional<Card> card = {};
};

/// What is known of pictures before the first moment.
struct PlannedPicture {
  ImageSize size = {1280, 720};
  std::vector<PlannedWork> work = {};
  std::vector<std::string> badges = {};  // that frames of the video have
};

/// Makes frames at any time from moments in order: the moment between its two neighbours, and the overlays as of then.
/// Depends on the moments alone, so a frame is the same in a run, from its take and as a still.
class FrameComposer {
 public:
  /// `planned`: by which corners of insets and legends and the room of the title are chosen.
  FrameComposer(std::string title, const OverlayChoice& choice, const ViewDefinition& view = {},
                const AnnotationDefinition& annotations = {}, PlannedPicture planned = {});

  /// The next moment, in order of time.
  void add(Moment moment);

  /// The time of the last moment, seconds; nothing before there is one.
  std::optional<double> last_time() const;

  /// Whether `time` (seconds) lies up to the last moment, which `compose` needs.
  bool reaches(double time) const;

  /// The frame at `time`, which must lie between the last two moments (or at the first, when there is one only).
  Frame compose(double time) const;

 private:
  OverlayContent overlay(const Snapshot& snapshot) const;
  const SnapshotTool* shown_tool(const Snapshot& snapshot) const;
  /// Of the tools that count, none perhaps.
  const SnapshotTool* last_to_set_out(const Snapshot& snapshot, bool (*counts)(const SnapshotTool& tool)) const;
  std::vector<ForceSample> history_of(std::size_t tool, const Snapshot& snapshot) const;
  void choose_corners();
  void tell_halves(OverlayContent& content) const;
  void add_second(const Moment& moment);
  void compose_second(double time, const Moment& earlier, Frame& frame) const;

  std::string title_;
  OverlayChoice choice_;
  std::optional<Legend> legend_;         // of the view's data
  std::optional<Legend> second_legend_;  // of those of the second take
  ViewDefinition view_;
  PlannedPicture planned_;
  std::optional<ClearCorners> corners_;  // since the first moment
  ShotFollower shots_;
  std::shared_ptr<const AnnotationDefinition> annotations_;
  std::optional<Moment> earlier_;
  std::optional<Moment> later_;
  std::vector<std::vector<ForceSample>> histories_;  // (tools x moments so far)
  SetAsideTools set_aside_, second_set_aside_;
  std::shared_ptr<const TakeComparison> comparison_;
  std::optional<ShotFollower> second_shots_;
  std::vector<std::vector<ForceSample>> second_histories_;  // like `histories_`, of the second take
  double expected_force_ = 1;                               // newton
  bool has_worked_ = false;      // whether a tool that a clip drives has touched, up to `earlier_`
  std::size_t last_active_ = 0;  // the tool that last did, else the one that last was driven
};

}  // namespace thinwall
