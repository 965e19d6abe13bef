#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/cutting/Cut.hpp"
#include "engine/cutting/CutPlanning.hpp"

namespace thinwall {

/// The path from where the cut has got to its end, on the patch as it is now; triangles are those of the patch.
std::vector<SurfacePoint> rest_of(std::span<const PathStop> stops, const PlannedCut& plan);

/// Where new and moved vertices of `after` lie on `before`; all numbers are those of the patch. `triangles` are the
/// sources of its changed triangles, ascending, `originals` the doubled vertices behind the last vertices of `after`.
/// Both lips of an earlier cut have the same places: a vertex on one is told to lie on its own side.
std::vector<VertexSource> vertex_sources(const CutPatch& before, const CutPatch& after,
                                         std::span<const TriangleSource> triangles, std::span<const int> originals);

/// For each edge of the border of `before` that has been split: its vertices now, in the sense of its triangle.
std::vector<std::vector<int>> split_borders(const CutPatch& before, const CutPatch& after);

/// The vertex of the patch at which the path ends and will stay single, if so. Before the lips are opened.
std::optional<int> tip_of(const PlannedCut& plan);

/// Counts moved vertices, and the changes of rest area, enclosed volume and Euler characteristic.
void count_changes(const CutPatch& before, const CutPatch& after, Cut& result);

}  // namespace thinwall
