#pragma once

#include <vector>

#include "engine/cutting/SurfaceCurve.hpp"

namespace thinwall {

/// Why two points could not be joined.
enum class TraceRefusal {
  kNone,
  kAlongNormal,  // one lies behind the other along the normal, or their normals oppose: no plane is told apart
  kNotJoined     // the plane's curves through the two are not connected
};

/// The way from one point of a surface to another.
struct SurfaceTrace {
  std::vector<SurfaceCurve> pieces;  // none when refused; more than one where the way crosses gaps
  TraceRefusal refusal = TraceRefusal::kNone;
};

/// A point that lies within 1e-12 of the largest coordinate of an edge or a corner of its triangle, brought there.
SurfacePoint snapped_to_edges(const SurfaceView& surface, SurfacePoint point);

/// The curve between two points of a surface in which it meets the plane through both that contains the mean of their
/// inward normals; of two ways the shorter one. Topologically exact, as `plane_section` says; both ways to count
/// vertices in the plane are tried.
///
/// Where the curve comes to the surface's border it goes straight on to where the curve begins again: forwards to
/// within 75 degrees at both lips, by their last triangles or seen from as far as the gap is wide, on a closed surface
/// also as seen along the line from one point to the other (lips may hang in); or by less than half the length of the
/// triangles there (lips may overlap). A gap counts three times its length. Then each piece begins and ends at border
/// edges, but for the two points. Points follow one another without repeating; the first of all and the last are the
/// given ones, brought to the edge or corner that they touch. A piece is one point alone where the given point lies on
/// the lip, or the two are the same.
SurfaceTrace trace(const SurfaceView& surface, const SurfacePoint& from, const SurfacePoint& to);

}  // namespace thinwall
