#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studio/scenario/CheckedValue.hpp"

namespace thinwall {

/// Steps of no run that ends: months of computing, and a take that no disk holds.
inline constexpr double kMostSteps = 1e7;

/// When a clip is played, as far as it is known before the simulation: how long a palpation lasts depends on where the
/// tool meets the wall.
struct ClipTimes {
  std::string path = {};  // "timeline[2].move"
  SourceLocation location = {};
  std::string tool = {};             // that it drives, or chamber that it fills; "" for none
  std::optional<double> start = {};  // seconds, when known
  std::optional<double> end = {};    // seconds, when known
  double shortest_duration = 0;      // seconds: a lower bound
};

/// The clips of a scenario, in the order of the file.
std::vector<ClipTimes> clip_times(const CheckedValue& root);

/// Whether the two drive at one time for certain.
bool certainly_overlap(const ClipTimes& a, const ClipTimes& b);

/// Whether no other clip of the same tool begins before it, as far as that is known; in the order of the file where it
/// is not.
bool is_first_of_its_tool(const std::vector<ClipTimes>& clips, std::size_t index);

/// When the last clip ends, seconds; empty when that is not known or there is no clip.
std::optional<double> end_of_timeline(const std::vector<ClipTimes>& clips);

}  // namespace thinwall
