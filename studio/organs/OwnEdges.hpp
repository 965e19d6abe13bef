#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "studio/organs/MeshFile.hpp"

namespace thinwall {

/// How many edges belong to one face only, as the file itself counts its vertices: those of borders, and of faces that
/// lie against each other without sharing their corners, as at a slit. `raw`: what was read of the file. Nothing for
/// formats other than OBJ, PLY and OFF, which cannot share vertices or divide them for their textures, and for files
/// whose faces share hardly any.
std::optional<std::size_t> own_open_edges(const std::filesystem::path& file, const RawMesh& raw);

}  // namespace thinwall
