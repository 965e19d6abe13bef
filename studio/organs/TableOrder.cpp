#include "studio/organs/TableOrder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "studio/organs/ObjOutline.hpp"
#include "studio/scenario/InputError.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// Of the extent: twice what the import welds.
constexpr double kPlaceTolerance = 2e-6;

/// Of the largest coordinate: what is lost where coordinates go through single precision.
constexpr double kSinglePrecision = 2.5e-7;

/// Finds points near others.
class PlaceIndex {
 public:
  PlaceIndex(const std::vector<Eigen::Vector3d>& points, double tolerance) : points_(points), tolerance_(tolerance) {
    for (std::size_t i = 0; i < points.size(); ++i) cells_[cell_of(points[i])].push_back(static_cast<int>(i));
  }

  /// In rising order.
  std::vector<int> near(const Eigen::Vector3d& place) const {
    std::vector<int> found;
    const Cell low = cell_of(place.array() - tolerance_), high = cell_of(place.array() + tolerance_);
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          const auto cell = cells_.find({x, y, z});
          if (cell == cells_.end()) continue;
          for (const int i : cell->second) {
            if ((points_[i] - place).norm() <= tolerance_) found.push_back(i);
          }
        }
      }
    }
    std::ranges::sort(found);
    return found;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(const Eigen::Vector3d& place) const {
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<std::int64_t>(std::floor(place[axis] / (4 * tolerance_)));
    }
    return cell;
  }

  const std::vector<Eigen::Vector3d>& points_;
  double tolerance_;
  std::map<Cell, std::vector<int>> cells_;
};

double place_tolerance(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d low = points.front(), high = points.front();
  for (const Eigen::Vector3d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  return kPlaceTolerance * (high - low).norm() + kSinglePrecision * largest;
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return extension;
}

/// The vertices and faces of a file, before anything is welded, turned or removed.
struct CountedSurface {
  std::vector<Eigen::Vector3d> vertices = {};  // (vertices x 3), metres
  std::vector<std::vector<int>> faces = {};    // (faces), the corners of each, into vertices
};

/// The vertex of a face that is one of those at a place; -1 when none is.
int corner_among(const std::vector<int>& face, const std::vector<int>& at_place) {
  for (const int v : face) {
    if (std::ranges::binary_search(at_place, v)) return v;
  }
  return -1;
}

class OrderFinder {
 public:
  OrderFinder(const SurfaceMesh& wall, const std::string& path, const SourceLocation& location)
      : wall_(wall), path_(path), location_(location) {}

  TableOrder of_shape() {
    surface_.vertices = wall_.vertices;
    for (const Eigen::Vector3i& t : wall_.triangles) surface_.faces.push_back({t[0], t[1], t[2]});
    return find();
  }

  TableOrder of_file(const MeshFileSource& source) {
    if (source.edge_length > 0) {
      refuse(
          "`remesh` makes other triangles than the mesh file has; save a mesh that is fine enough and leave `remesh` "
          "out, or use regions");
    }
    const std::string extension = lower_extension(source.file);
    if (extension != ".ply" && extension != ".obj") {
      refuse("a " + in_backticks(extension) +
             " file does not number its vertices and faces; save the mesh as PLY or OBJ, or use regions");
    }
    try {
      extension == ".ply" ? read_ply_surface(source.file) : read_obj_surface(source.file);
    } catch (const FileFormatError& error) {
      throw InputErrors({{error.location(), path_ + ": " + error.what()}});
    }
    for (Eigen::Vector3d& vertex : surface_.vertices) {
      vertex *= source.unit;
      if (source.placed) vertex = source.placed->place_of(vertex);
    }
    return find();
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputErrors({{location_, path_ + ": " + message}});
  }

  void read_ply_surface(const std::filesystem::path& file) {
    order_.ply = read_ply(file);
    surface_ = {order_.ply->vertices, order_.ply->faces};
  }

  void read_obj_surface(const std::filesystem::path& file) {
    ObjOutline outline = read_obj_outline(file);
    surface_ = {std::move(outline.vertices), std::move(outline.faces)};
  }

  TableOrder find() {
    order_.vertices = surface_.vertices.size();
    order_.faces = surface_.faces.size();
    faces_of_.resize(surface_.vertices.size());
    for (std::size_t f = 0; f < surface_.faces.size(); ++f) {
      for (const int v : surface_.faces[f]) faces_of_[v].push_back(static_cast<int>(f));
    }
    const PlaceIndex index(surface_.vertices, place_tolerance(surface_.vertices));
    for (const Eigen::Vector3d& vertex : wall_.vertices) at_vertex_.push_back(index.near(vertex));
    for (const Eigen::Vector3i& triangle : wall_.triangles) add(triangle);
    return std::move(order_);
  }

  /// Finds the faces that a triangle may come from: the first counts.
  void add(const Eigen::Vector3i& triangle) {
    std::vector<int> faces;
    for (const int v : at_vertex_[triangle[0]]) faces.insert(faces.end(), faces_of_[v].begin(), faces_of_[v].end());
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    const std::size_t known = order_.face_rows.size();
    for (const int f : faces) {
      std::array<int, 3> rows{};
      for (int k = 0; k < 3; ++k) rows[k] = corner_among(surface_.faces[f], at_vertex_[triangle[k]]);
      if (std::ranges::min(rows) < 0) continue;
      if (order_.face_rows.size() == known) {
        order_.face_rows.push_back(f);
        order_.corner_rows.push_back(rows);
        continue;
      }
      order_.doubled_faces.push_back({order_.face_rows.back(), f});
      for (int k = 0; k < 3; ++k) {
        if (rows[k] != order_.corner_rows.back()[k]) {
          order_.doubled_vertices.push_back({order_.corner_rows.back()[k], rows[k]});
        }
      }
    }
    if (order_.face_rows.size() == known) refuse_changed(triangle);
  }

  [[noreturn]] void refuse_changed(const Eigen::Vector3i& triangle) const {
    const Eigen::Vector3d middle =
        1e3 * (wall_.vertices[triangle[0]] + wall_.vertices[triangle[1]] + wall_.vertices[triangle[2]]) / 3;
    refuse(
        fmt::format("the triangle of the wall at [{:.4g}, {:.4g}, {:.4g}] mm is none of the mesh file's faces: the "
                    "import changed it; mend the mesh in a modelling program, save it and leave `repair` out, or "
                    "use regions",
                    middle.x() + 0.0, middle.y() + 0.0, middle.z() + 0.0));
  }

  const SurfaceMesh& wall_;
  const std::string& path_;
  const SourceLocation& location_;
  CountedSurface surface_;
  std::vector<std::vector<int>> faces_of_;   // (vertices of the file), faces
  std::vector<std::vector<int>> at_vertex_;  // (vertices of the wall), vertices of the file there
  TableOrder order_;
};

}  // namespace

TableOrder table_order(const std::variant<MeshFileSource, ShapeSource>& source, const SurfaceMesh& wall,
                       const std::string& path, const SourceLocation& location) {
  OrderFinder finder(wall, path, location);
  const auto* file = std::get_if<MeshFileSource>(&source);
  return file == nullptr ? finder.of_shape() : finder.of_file(*file);
}

}  // namespace thinwall
