#pragma once

#include <optional>
#include <vector>

#include "renderer/annotation/Annotation.hpp"
#include "renderer/camera/View.hpp"
#include "renderer/overlay/Overlay.hpp"
#include "studio/recorder/PlannedWork.hpp"

namespace thinwall {

/// What corners are chosen by: all of it is known when the first picture is drawn.
struct CornerQuestion {
  const Snapshot& first;  // moment
  const ViewDefinition& view;
  const AnnotationDefinition& annotations;
  const std::vector<PlannedWork>& work;
  ImageSize size;               // of the pictures
  double end = 0;               // seconds, as planned
  OverlayContent legends = {};  // with those that there are
};

/// The corners of insets and legends, where the scenario does not say them: the upper right one, unless it covers what
/// clips do or what labels, arrows and marks point at; then the one that covers least of that, and of those that cover
/// equally little the one that covers least of the organs. The same from the first picture of a cut to its last, and a
/// legend's of all pictures, where there is one that no inset of some cuts alone makes give way.
class ClearCorners {
 public:
  explicit ClearCorners(const CornerQuestion& question);

  /// Of the inset that is shown at `time` (seconds), where the scenario leaves it open.
  std::optional<PictureCorner> inset(double time) const;
  PictureCorner legend() const { return legend_; }

 private:
  struct Shown {
    double begin = 0;  // seconds
    std::optional<PictureCorner> corner = {};
  };
  std::vector<Shown> cuts_;  // ascending in time
  PictureCorner legend_ = PictureCorner::kUpperRight;
};

}  // namespace thinwall
