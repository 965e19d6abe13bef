#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace thinwall {

/// The head of a binary STL file beside what the file holds.
struct StlHead {
  std::uint32_t announced = 0;      // triangles
  std::uintmax_t present = 0;       // whole triangles that the file has room for
  std::uintmax_t bytes_behind = 0;  // those announced; 0 where none are announced, or fewer are there
};

/// Nothing for a file that cannot be read, is named otherwise than `.stl`, is too short or is text.
std::optional<StlHead> binary_stl_head(const std::filesystem::path& file);

/// The bytes of a binary STL file without what stands behind its triangles, as some programs leave it there; nothing
/// where nothing does. Assimp takes a file for binary only where its length is that of the triangles announced.
std::optional<std::string> shortened_stl(const std::filesystem::path& file);

}  // namespace thinwall
