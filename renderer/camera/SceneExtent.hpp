#pragma once

#include <memory>
#include <span>
#include <vector>

#include "renderer/snapshot/BorderEdges.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// How far walls at rest reach along the axes: means over their area of the products of the places' distances from the
/// middle of the scene, square metres. Triangles that a cut divides do not change it.
struct WallSpread {
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;

  /// The same mean of the distances along two directions, unit.
  double along(const Vector3& a, const Vector3& b) const {
    return xx * a.x * b.x + yy * a.y * b.y + zz * a.z * b.z + xy * (a.x * b.y + a.y * b.x) +
           yz * (a.y * b.z + a.z * b.y) + zx * (a.z * b.x + a.x * b.z);
  }
};

/// Where a scene is and how large, so that camera, light, tools and patterns fit organs of any size.
struct SceneExtent {
  std::vector<Vector3> rest_points;  // all stress-free vertices: cuts add some on the same triangles
  // Vertices as they are now, but for pieces that were cut out, of walls that have grown beyond the box of their rest
  // points: a camera that nobody has placed goes back for them. None of others.
  std::vector<Vector3> grown_points = {};
  WallSpread spread = {};
  Vector3 center;           // metres, of the box around the rest points
  double size = 0.1;        // metres, diagonal of that box; 0.1 where there is no surface
  double floor_height = 0;  // metres, z of the floor below everything but pieces that were cut out and fall
  double reach = 0.05;      // metres, radius around `center` of the current surfaces, rounded up in coarse steps
  std::shared_ptr<const SceneExtent> acting = {};  // of what is not scenery, where both are there

  /// What pictures are of: all but the scenery.
  const SceneExtent& subject() const { return acting ? *acting : *this; }
};

/// Throws PictureFailure naming the body whose arrays do not fit together or are not finite.
SceneExtent scene_extent(const Snapshot& snapshot);

/// z of a cloth that the surfaces lie on, metres. A sheet touches it with its ends and may be pressed down between
/// them, where cloth gives way. `ends`: (surfaces), their borders that no cut has made.
double lying_height(const Snapshot& snapshot, std::span<const std::vector<BorderEdge>> ends);

}  // namespace thinwall
