#pragma once

#include <cstddef>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Which tools are out of the picture, told from the moments of a take in order. A tool that has gone back, or that no
/// clip has driven yet, is set aside when another one begins, until it is driven itself, but while a wall touches it:
/// at its stand-off it would hang before the work of the other. A tool that was left in a wall, holds one, or was moved
/// somewhere stays, and so do forceps that have let go.
class SetAsideTools {
 public:
  void add(const Snapshot& snapshot);

  /// Marks the tools of a snapshot that are set aside: as of the last moment, or of the one before it where the
  /// snapshot's time does not reach the last one.
  void mark(Snapshot& snapshot) const;

  /// When a tool last set out from rest, as of `time`, seconds; -1 where it never did.
  double begun(std::size_t tool, double time) const;

 private:
  struct State {
    bool is_placed = false;   // where a clip has left it on purpose
    bool is_outdone = false;  // another tool has begun since it was at work
    bool is_idle = true;
    bool is_at_work = false;
    bool lets_go = false;
    double opening = 0;  // metres between jaws
    double begun = -1;   // seconds, when a clip last drove it from rest; -1 never

    /// To the next moment, as far as the tool itself goes.
    void go_on(const SnapshotTool& tool);
  };

  const std::vector<State>& states(double time) const;

  double time_ = 0;  // seconds, of the last moment
  std::vector<State> earlier_, later_;
};

}  // namespace thinwall
