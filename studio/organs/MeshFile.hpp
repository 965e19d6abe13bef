#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace thinwall {

/// The triangles of a mesh file as they stand there.
struct RawMesh {
  std::vector<Eigen::Vector3d> vertices;             // (vertices x 3), units of the file
  std::vector<Eigen::Vector3i> triangles;            // (triangles x 3)
  std::vector<int> parts;                            // (triangles), into part_names
  std::vector<std::vector<std::string>> part_names;  // names of the part's group or object, and of its material
};

/// What a mesh file may ask for, so that a broken or hostile one costs neither the memory nor the evening.
struct MeshFileLimits {
  std::uintmax_t file_bytes = 256u << 20;
  int triangles = 1'000'000;
  std::uintmax_t memory_bytes = 4ull << 30;  // beyond what the program itself has mapped
  int processor_seconds = 20;
};

/// A mesh file that cannot be read; the message says why, without the file's name.
class MeshFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads any mesh file that assimp reads (OBJ, PLY, STL, OFF, glTF, ...), polygons split into triangles, the placements
/// of its objects applied. The reading happens in a child process under the limits, because assimp crashes or runs away
/// on some malformed files; the child's end is the file's fault and told as such.
/// Throws MeshFileError: missing, empty, over a limit, unreadable, without triangles, corners that are no vertices.
RawMesh read_mesh_file(const std::filesystem::path& file, const MeshFileLimits& limits = {});

}  // namespace thinwall
