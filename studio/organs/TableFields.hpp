#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/mesh/SurfaceMesh.hpp"
#include "studio/organs/TableOrder.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// The numbers of one column at the corners of each triangle; three times the same where a face has one number.
using CornerNumbers = std::vector<std::array<double, 3>>;  // (triangles), SI

/// Brings the numbers of tables and of a mesh file's properties to the triangles of a wall.
class TableFields {
 public:
  /// `notes`: where it is told what was read.
  TableFields(const std::variant<MeshFileSource, ShapeSource>& source, const SurfaceMesh& wall,
              std::vector<std::string>& notes)
      : source_(source), wall_(wall), notes_(notes) {}

  /// The columns of the table in its order. `ranges`: of each column's numbers, SI. `path` and `location` are those of
  /// the field. Throws InputErrors: see table_order and read_csv_columns; properties that the mesh file lacks or has
  /// for both vertices and faces; another count of rows than vertices or faces; numbers that are not finite or out of
  /// range; numbers of rows that lie on each other and differ by more than 1e-6 of them.
  std::vector<CornerNumbers> read(const FieldTable& table, const std::vector<Range>& ranges, const std::string& path,
                                  const SourceLocation& location);

 private:
  const std::variant<MeshFileSource, ShapeSource>& source_;
  const SurfaceMesh& wall_;
  std::vector<std::string>& notes_;
  std::optional<TableOrder> order_;  // found when it is first asked for
};

}  // namespace thinwall
