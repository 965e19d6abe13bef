#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "studio/organs/FileFormatError.hpp"

namespace thinwall {

/// The vertices and faces of an OBJ file as its lines `v` and `f` count them.
struct ObjOutline {
  std::vector<Eigen::Vector3d> vertices;  // (vertices x 3), units of the file
  std::vector<std::vector<int>> faces;    // (faces), each three or more corners
};

struct ObjLimits {
  std::uintmax_t file_bytes = 256u << 20;
  std::size_t numbers = 20'000'000;  // coordinates and corners
};

/// Reads the lines `v` and `f` of an OBJ file and passes over all others. Format: Wavefront, Advanced Visualizer
/// manual, appendix B1. Throws FileFormatError at the line: missing, over a limit, a coordinate that is no finite
/// number, corners that are no vertices, a line that is continued by `\`.
ObjOutline read_obj_outline(const std::filesystem::path& file, const ObjLimits& limits = {});

}  // namespace thinwall
