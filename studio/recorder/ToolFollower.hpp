#pragma once

#include <string>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// The path of a tool's tip made smooth for a camera that follows it: two low-pass filters of first order in a row,
/// each with half of the smoothing time, solved exactly for a tip that moves straight between moments. So the path
/// depends on the moments alone and not on which frames are drawn, never overshoots by a jump of the tip, and lags
/// behind a tip of constant velocity by the smoothing time.
class ToolFollower {
 public:
  /// `smoothing` in seconds; with zero the path is the tip's own.
  ToolFollower(std::string tool, double smoothing);

  /// The next moment, in order of time. At the first one the path begins at the tip.
  void add(const Snapshot& snapshot);

  /// The place (metres) at `snapshot`, which lies between the last two moments.
  Double3 at(const Snapshot& snapshot) const;

 private:
  struct State {
    double time = 0;  // seconds
    Double3 tip = {};
    Double3 once = {};   // smoothed
    Double3 twice = {};  // and again
  };
  State advanced(const State& from, double time, const Double3& tip) const;
  const Double3& tip_in(const Snapshot& snapshot) const;

  std::string tool_;
  double constant_;  // seconds, of each filter
  bool has_begun_ = false;
  State earlier_;
  State later_;
};

}  // namespace thinwall
