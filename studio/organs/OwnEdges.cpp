#include "studio/organs/OwnEdges.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <vector>

#include "studio/organs/ObjOutline.hpp"

namespace thinwall {
namespace {

class EdgeCount {
 public:
  template <typename Corners>
  void add(const Corners& corners, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const auto [low, high] = std::minmax<int>(corners[k], corners[(k + 1) % count]);
      ++faces_[{low, high}];
    }
  }

  std::optional<std::size_t> open() const {
    const auto open =
        static_cast<std::size_t>(std::ranges::count_if(faces_, [](const auto& edge) { return edge.second == 1; }));
    // Of triangles that lie loose all edges are open, and four of five of loose squares that are split in two.
    if (4 * open > 3 * faces_.size()) return std::nullopt;
    return open;
  }

 private:
  std::map<std::array<int, 2>, int> faces_;  // of each edge
};

}  // namespace

std::optional<std::size_t> own_open_edges(const std::filesystem::path& file, const RawMesh& raw) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  EdgeCount edges;
  if (extension == ".obj") {
    // Of an OBJ file each face has been read with corners of its own.
    try {
      for (const std::vector<int>& face : read_obj_outline(file).faces) edges.add(face, face.size());
    } catch (const FileFormatError&) {
      // What the outline does not take, such as continued lines, is read all the same: only this count is missing.
      return std::nullopt;
    }
  } else if (extension == ".ply" || extension == ".off") {
    for (const Eigen::Vector3i& triangle : raw.triangles) edges.add(triangle, 3);
  } else {
    return std::nullopt;
  }
  return edges.open();
}

}  // namespace thinwall
