#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace thinwall {

/// The bytes of a PLY file that holds the vertices and faces of `file` and nothing else; nothing where assimp reads
/// `file` itself rightly, or where the header is malformed, which assimp tells. The format allows elements of any name
/// in any order, but assimp counts wrongly from one on whose name it does not know, and refuses faces before vertices.
/// It gets the file all the same, for it is what divides faces of more than three corners.
/// Throws FileFormatError: the file cannot be read (see read_ply), or has more than `most_bytes`.
std::optional<std::string> reordered_ply(const std::filesystem::path& file, std::uintmax_t most_bytes);

}  // namespace thinwall
