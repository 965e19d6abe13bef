#pragma once

#include <map>
#include <string>

#include "renderer/camera/View.hpp"
#include "studio/recorder/ToolFollower.hpp"

namespace thinwall {

/// The shots of a recording: what its cuts show, with cameras that know where the tools are that they follow.
class ShotFollower {
 public:
  explicit ShotFollower(const ViewDefinition& view);

  /// The next moment, in order of time.
  void add(const Snapshot& snapshot);

  /// What is shown at `snapshot`, which lies between the last two moments, of a recording that ends at `end` (seconds)
  /// as far as is known.
  Shot shot(const Snapshot& snapshot, double end) const;

 private:
  CameraDefinition as_it_is(CameraDefinition camera, const Snapshot& snapshot, double end) const;

  ViewDefinition view_;
  std::map<std::pair<std::string, double>, ToolFollower> followers_;  // by tool and smoothing time
};

}  // namespace thinwall
