#include "renderer/shape/WoundLayout.hpp"

#include <algorithm>
#include <utility>

#include "renderer/wound/RunFeet.hpp"

namespace thinwall {
namespace {

constexpr double kBloodSpacing = 0.014;  // metres between runs of blood, and of what has been in the body
constexpr double kFluidSpacing = 0.007;
constexpr double kLongestRun = 0.045;    // metres
constexpr double kLevelRun = 0.006;      // metres, of blood that wells over a lip of a level wall
constexpr double kRunsOffEnds = 0.0015;  // metres from the ends of a cut, where lips lie together and no run begins
constexpr double kFluidPush = 0.02;      // metres over level wall, of what the body presses out

/// Of a cut too short for runs off its ends, those that begin anywhere, once it has not gone on for a while.
std::vector<FluidRun> find_runs_off_ends(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                                         std::span<const char> is_lip, Vector3 down, RunReach reach) {
  constexpr double kWhile = 0.3;  // seconds
  std::vector<FluidRun> runs = find_runs(topology, borders, is_lip, down, reach);
  if (!runs.empty() || !(reach.off_ends > 0)) return runs;
  reach.off_ends = 0;
  runs = find_runs(topology, borders, is_lip, down, reach);
  for (FluidRun& run : runs) run.born = std::ranges::max(topology.cut_times) + kWhile;
  return runs;
}

}  // namespace

WoundLayout lay_out_wounds(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                           std::span<const char> is_lip, Vector3 down) {
  WoundMap map = map_wounds(topology, borders, is_lip);
  const bool is_cut = map.goes_on();
  const RunReach blood{.spacing = kBloodSpacing,
                       .longest = kLongestRun,
                       .level = kLevelRun,
                       .off_begin = is_cut ? kPoolsOffEnds : 0,
                       .off_ends = is_cut ? kRunsOffEnds : 0,
                       .map = &map};
  const RunReach fluid{
      .spacing = kFluidSpacing, .longest = kLongestRun, .push = kFluidPush, .off_ends = blood.off_ends, .map = &map};
  std::vector<FluidRun> blood_runs = find_runs_off_ends(topology, borders, is_lip, down, blood);
  std::vector<FluidRun> fluid_runs = find_runs_off_ends(topology, borders, is_lip, down, fluid);
  WoundLayout layout{.map = std::move(map),
                     .fringe = {},
                     .fall = std::vector<double>(is_lip.size(), 0),
                     .blood_runs = std::move(blood_runs),
                     .fluid_runs = std::move(fluid_runs),
                     .blood_feet = {},
                     .fluid_feet = {}};
  layout.blood_feet = run_feet(topology, borders, is_lip, layout.blood_runs);
  layout.fluid_feet = run_feet(topology, borders, is_lip, layout.fluid_runs);
  for (const auto& [start, end, triangle] : borders) {
    if (!is_lip[start] || !is_lip[end]) continue;
    const Vector3 a = vector3(topology.rest_positions[start]), b = vector3(topology.rest_positions[end]);
    for (const std::uint32_t corner : topology.triangles[triangle]) {
      if (corner == start || corner == end) continue;
      const double fall = dot(normalized(vector3(topology.rest_positions[corner]) - 0.5 * (a + b)), down);
      layout.fall[start] += 0.5 * fall;
      layout.fall[end] += 0.5 * fall;
    }
  }
  return layout;
}

}  // namespace thinwall
