#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/cutting/SurfaceCurve.hpp"

namespace thinwall {

/// A straight edge of a blade.
struct BladeEdge {
  Eigen::Vector3d begin = Eigen::Vector3d::Zero();  // metres
  Eigen::Vector3d end = Eigen::Vector3d::Zero();    // metres
};

/// A curve in which a blade's edge met a wall.
struct SweptCurve {
  SurfaceCurve curve;
  std::vector<double> motion;  // (points), 0 at the edge's first place, 1 at its last
  std::vector<double> along;   // (points), 0 at the beginning of the edge, 1 at its end
};

/// Where the surface that an edge sweeps from one place to another meets a wall; one curve for each wall that it goes
/// through, and more where it meets one again. The swept surface is taken as two triangles: from the edge's first place
/// to its last end, and on to its last place. Curves begin at their smaller `motion` (smaller `along` where both ends
/// have the same), and come in that order; closed ones begin at their smallest. Nothing where nothing is swept.
///
/// Exact in its topology: every sign is that of an exact volume on a grid of 2e-12 of the extent, and where that is
/// zero, of the volume after the blade was shifted by less than any length along a direction that lies in no plane of
/// the grid. All degenerate positions (through vertices, along edges, along the edge itself) are general ones then, so
/// that curves neither branch nor break; triangles that lie in the swept surface are not met. A symbolic shift was
/// chosen over rounding predicates, which can contradict each other, and over shifting each vertex on its own, which
/// would make a curve that follows a row of vertices change sides at each. Points are within 3e-12 of the extent of
/// both surfaces.
std::vector<SweptCurve> swept_section(const SurfaceView& surface, const BladeEdge& first, const BladeEdge& last);

}  // namespace thinwall
