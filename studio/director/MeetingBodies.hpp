#pragma once

#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/Body.hpp"

namespace thinwall {

/// Watches for bodies that come near each other: they do not feel each other, which a reader of the results must know.
class MeetingBodies {
 public:
  /// One sentence for each pair whose upright boxes overlap now for the first time, but for what lies in scenery from
  /// the beginning. `time`: seconds.
  std::vector<std::string> notes(std::span<const std::unique_ptr<Body>> bodies, double time);

 private:
  std::set<std::pair<std::size_t, std::size_t>> told_;  // indices of bodies, ascending
};

}  // namespace thinwall
