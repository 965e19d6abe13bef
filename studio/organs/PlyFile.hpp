#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "studio/organs/FileFormatError.hpp"

namespace thinwall {

/// A property with one number for each vertex or face.
struct PlyProperty {
  std::string name;
  std::vector<double> values;  // (vertices) or (faces), as the file has them
};

/// What a PLY file holds, in the order of the file.
struct PlyFile {
  std::vector<Eigen::Vector3d> vertices;       // (vertices x 3), units of the file
  std::vector<std::vector<int>> faces;         // (faces), the corners of each, into vertices
  std::vector<PlyProperty> vertex_properties;  // without x, y, z
  std::vector<PlyProperty> face_properties;
  std::vector<int> vertex_lines;  // (vertices) where each begins; none in a binary file
  std::vector<int> face_lines;    // (faces)
};

struct PlyLimits {
  std::uintmax_t file_bytes = 256u << 20;
  std::size_t numbers = 20'000'000;  // in all, corners of faces too
};

/// Reads a PLY file, ascii or binary of either byte order, with all scalar properties of its vertices and faces; other
/// elements and lists are passed over. Format: G. Turk, The PLY Polygon File Format, 1994.
/// Throws FileFormatError: missing, over a limit, malformed, cut off, corners that are no vertices, coordinates that
/// are no finite numbers; at the line and column, or with the byte in a binary part.
PlyFile read_ply(const std::filesystem::path& file, const PlyLimits& limits = {});

}  // namespace thinwall
