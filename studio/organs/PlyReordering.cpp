#include "studio/organs/PlyReordering.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

#include "studio/organs/PlyFile.hpp"
#include "studio/organs/PlyHeader.hpp"

namespace thinwall {
namespace {

/// Elements that assimp knows wherever they stand.
constexpr std::array<std::string_view, 5> kKnown = {"vertex", "face", "edge", "material", "tristrips"};

bool is_misread(const PlyHeader& header) {
  const auto place = [&](std::string_view name) {
    return std::ranges::find_if(header.elements, [&](const PlyHeaderElement& own) { return own.name == name; });
  };
  const auto vertex = place("vertex");
  const auto face = place("face");
  if (vertex == header.elements.end() || face == header.elements.end()) return false;
  if (face < vertex) return true;
  return std::any_of(header.elements.begin(), face, [](const PlyHeaderElement& element) {
    return std::ranges::find(kKnown, element.name) == kKnown.end();
  });
}

template <typename Value>
void append(std::string& bytes, const Value* values, std::size_t count) {
  static_assert(std::endian::native == std::endian::little);
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
}

std::string vertices_and_faces(const PlyFile& ply) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list int int vertex_indices\nend_header\n",
      ply.vertices.size(), ply.faces.size());
  for (const Eigen::Vector3d& vertex : ply.vertices) append(bytes, vertex.data(), 3);
  for (const std::vector<int>& face : ply.faces) {
    const int corners = static_cast<int>(face.size());
    append(bytes, &corners, 1);
    append(bytes, face.data(), face.size());
  }
  return bytes;
}

}  // namespace

std::optional<std::string> reordered_ply(const std::filesystem::path& file, std::uintmax_t most_bytes) {
  const std::string bytes = read_file_bytes(file, most_bytes);
  PlyCursor cursor(file, bytes);
  try {
    if (!is_misread(read_ply_header(cursor))) return std::nullopt;
  } catch (const FileFormatError&) {
    return std::nullopt;
  }
  return vertices_and_faces(read_ply(file, {.file_bytes = most_bytes}));
}

}  // namespace thinwall
