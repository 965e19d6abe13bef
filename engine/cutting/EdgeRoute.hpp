#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/cutting/CutPatch.hpp"

namespace thinwall {

/// The edges of a patch that lead from one vertex to another closest to a polyline: least integral of length times
/// (1 + squared distance in edge lengths). Vertices in order; empty where no way leads there off the frozen triangles.
std::vector<int> route_along_edges(const CutPatch& patch, int from, int to, std::span<const Eigen::Vector3d> polyline);

}  // namespace thinwall
