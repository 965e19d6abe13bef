#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

#include "engine/cutting/Cut.hpp"
#include "engine/cutting/SurfacePath.hpp"
#include "engine/simulation/Body.hpp"

namespace thinwall {

struct ScheduledClip;

/// The line of a path as a pen draws it on the wall: places of the wall, which it takes along where it goes.
struct MarkedPath {
  std::vector<SurfacePoint> places;                 // (stations), on the wall as it is now
  std::vector<PathStation> drawn;                   // (stations), where they were then
  std::vector<Eigen::Quaterniond> turns;            // (stations), by which the wall has turned since then
  double passed = 0;                                // metres of the path that the blade had passed when it last turned
  double outer = 1;                                 // -1 where the path's inner side is the one before the triangles
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();  // metres, by which the line moved under the blade in the last step
};

/// Of a path on the surface as it is now.
MarkedPath drawn_on_wall(const SurfacePath& path, const SurfaceView& wall);

/// By which the wall has turned at `along` metres of the path.
Eigen::Quaterniond turn_at(const SurfacePath& path, const MarkedPath& mark, double along);

/// Before a step that begins at `time`, seconds: brings what is ahead of the blades to where the wall has taken their
/// lines, and turns them and the blades with it. A blade that has just gone in comes to its line over its own width, as
/// the wall that it has dented springs back; what it has passed stays as it was, as the lips there part.
void follow_marks(std::span<ScheduledClip> clips, std::span<const std::unique_ptr<Body>> bodies,
                  std::span<const ToolDefinition> tools, double time);

/// Keeps the lines on a body that has been cut at their places of the stress-free wall. `before`: its mesh before.
void carry_over(std::span<ScheduledClip> clips, const Body& body, const SurfaceMesh& before, const Cut& cut);

}  // namespace thinwall
