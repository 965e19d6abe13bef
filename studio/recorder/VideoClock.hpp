#pragma once

#include <vector>

#include "studio/scenario/Teaching.hpp"

namespace thinwall {

/// What a video's time shows of the simulation's time.
struct VideoMoment {
  double simulation = 0;  // seconds
  double speed = 1;       // there; 0 while frozen
  double held = 0;        // seconds since it is frozen
};

/// The map from the time of a video to that of the simulation: straight pieces, steep where the simulation runs fast,
/// flat where it is frozen. A pure function of freezes and slow motions; without any the two times are equal to the
/// last bit.
class VideoClock {
 public:
  /// Freezes at the same time add up. Slow motions may touch but not overlap.
  explicit VideoClock(const std::vector<Freeze>& freezes = {}, const std::vector<SlowMotion>& slow_motions = {});

  /// What is shown at `video_time` (seconds, from 0).
  VideoMoment at(double video_time) const;

  /// When the video first shows `simulation_time` (seconds).
  double first_shown(double simulation_time) const;

  /// When the video last shows it: after a freeze at that time.
  double last_shown(double simulation_time) const;

 private:
  /// A straight piece that begins at two times.
  struct Piece {
    double video = 0;
    double simulation = 0;
    double speed = 1;  // 0: frozen
  };
  std::vector<Piece> pieces_;  // ascending in both times; the last one goes on for ever
};

}  // namespace thinwall
