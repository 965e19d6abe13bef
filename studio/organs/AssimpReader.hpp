#pragma once

#include <filesystem>
#include <string>

#include "studio/organs/MeshFile.hpp"

namespace thinwall {

/// Reads a mesh file with assimp in the calling process, which assimp may crash. Throws MeshFileError,
/// std::bad_alloc.
RawMesh read_with_assimp(const std::filesystem::path& file, const MeshFileLimits& limits);

}  // namespace thinwall
