#include "studio/organs/TableFields.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "studio/organs/CsvTable.hpp"
#include "studio/organs/SurfaceOrigin.hpp"
#include "studio/organs/ToldPlaces.hpp"
#include "studio/schema/Quantity.hpp"
#include "studio/schema/Schema.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// Of the numbers: single precision, in which many files hold them, is good to 1e-7.
constexpr double kRounding = 1e-6;

/// A column with the place of each number.
struct PlacedColumn {
  std::vector<double> values;             // (rows), units of the table
  std::vector<SourceLocation> locations;  // (rows)
};

const char* word_of(TablePer per) {
  return per == TablePer::kVertex ? "vertex" : "face";
}

std::string counted_rows(std::size_t count, TablePer per) {
  return per == TablePer::kVertex ? counted(count, "vertex", "vertices") : counted(count, "face", "faces");
}

const PlyProperty* find_property(const std::vector<PlyProperty>& properties, const std::string& name) {
  const auto found = std::ranges::find(properties, name, &PlyProperty::name);
  return found == properties.end() ? nullptr : &*found;
}

bool has_all(const std::vector<PlyProperty>& properties, const std::vector<std::string>& names) {
  return std::ranges::all_of(names, [&](const std::string& name) { return find_property(properties, name); });
}

/// Reads one table or one set of properties.
class TableReading {
 public:
  TableReading(const FieldTable& table, const TableOrder& order, std::filesystem::path mesh_file,
               const std::string& path, const SourceLocation& location)
      : table_(table), order_(order), mesh_file_(std::move(mesh_file)), path_(path), location_(location) {}

  const std::vector<std::string>& notes() const { return notes_; }

  std::vector<CornerNumbers> run(const std::vector<Range>& ranges) {
    std::vector<PlacedColumn> columns = table_.file.empty() ? read_properties() : read_table();
    for (std::size_t c = 0; c < columns.size(); ++c) check(columns[c], ranges[c]);
    throw_errors();
    for (const PlacedColumn& column : columns) check_doubled(column);
    throw_errors();
    describe(columns);
    std::vector<CornerNumbers> result;
    for (const PlacedColumn& column : columns) result.push_back(at_corners(column));
    return result;
  }

 private:
  [[noreturn]] void refuse(const SourceLocation& location, const std::string& message) const {
    throw InputErrors({{location, path_ + ": " + message}});
  }

  std::vector<PlacedColumn> read_table() {
    per_ = *table_.per;
    std::vector<PlacedColumn> columns;
    try {
      for (CsvColumn& read : read_csv_columns(table_.file, table_.columns)) {
        PlacedColumn column{std::move(read.values), {}};
        for (std::size_t row = 0; row < column.values.size(); ++row) {
          column.locations.push_back({table_.file, read.lines[row], read.columns[row]});
        }
        columns.push_back(std::move(column));
      }
    } catch (const FileFormatError& error) {
      refuse(error.location(), error.what());
    }
    check_count(columns.front());
    return columns;
  }

  std::size_t rows_of(TablePer per) const { return per == TablePer::kVertex ? order_.vertices : order_.faces; }

  void check_count(const PlacedColumn& column) const {
    const std::size_t rows = column.values.size();
    if (rows == rows_of(per_)) return;
    const TablePer other = per_ == TablePer::kVertex ? TablePer::kFace : TablePer::kVertex;
    const std::string hint = rows == rows_of(other) ? fmt::format("; write `per: {}`", word_of(other))
                                                    : "; write one row for each, in the order of the surface";
    const int line = rows == 0 ? 1 : column.locations.back().line;
    refuse({table_.file, line, 1}, fmt::format("the table has {}, but the surface has {}{}",
                                               counted(rows, "row", "rows"), counted_rows(rows_of(per_), per_), hint));
  }

  /// What has the properties: as told, or the only one.
  TablePer owner_of_properties() const {
    const bool at_vertices = has_all(order_.ply->vertex_properties, table_.columns);
    const bool at_faces = has_all(order_.ply->face_properties, table_.columns);
    if (!table_.per && at_vertices && at_faces) {
      refuse(location_, fmt::format("both the vertices and the faces of the mesh file have {}; write `per: vertex` or "
                                    "`per: face`",
                                    list_in_backticks(table_.columns)));
    }
    const bool found =
        table_.per ? (*table_.per == TablePer::kVertex ? at_vertices : at_faces) : at_vertices || at_faces;
    if (!found) refuse_properties();
    return table_.per.value_or(at_vertices ? TablePer::kVertex : TablePer::kFace);
  }

  [[noreturn]] void refuse_properties() const {
    const auto names_of = [](const std::vector<PlyProperty>& properties) {
      std::vector<std::string> names;
      for (const PlyProperty& property : properties) names.push_back(property.name);
      return names.empty() ? std::string("none") : list_in_backticks(names);
    };
    const std::string of = table_.per ? fmt::format(" for each {}", word_of(*table_.per)) : "";
    refuse(location_, fmt::format("the mesh file does not have {} with one number{}; its vertices have {}, its faces "
                                  "{}",
                                  list_in_backticks(table_.columns), of, names_of(order_.ply->vertex_properties),
                                  names_of(order_.ply->face_properties)));
  }

  std::vector<PlacedColumn> read_properties() {
    per_ = owner_of_properties();
    const PlyFile& ply = *order_.ply;
    const bool at_vertices = per_ == TablePer::kVertex;
    const std::vector<int>& lines = at_vertices ? ply.vertex_lines : ply.face_lines;
    std::vector<PlacedColumn> columns;
    for (const std::string& name : table_.columns) {
      PlacedColumn column{find_property(at_vertices ? ply.vertex_properties : ply.face_properties, name)->values, {}};
      for (std::size_t row = 0; row < column.values.size(); ++row) {
        column.locations.push_back(lines.empty() ? location_ : SourceLocation{mesh_file_, lines[row], 1});
      }
      columns.push_back(std::move(column));
    }
    return columns;
  }

  std::string shown(double value) const {
    return table_.example.empty() ? fmt::format("{:g}", value) : format_like(value, table_.example);
  }

  /// Most of the wrong numbers are wrong for one reason: the first tell it.
  void check(const PlacedColumn& column, const Range& range) {
    std::size_t wrong = 0;
    for (std::size_t row = 0; row < column.values.size(); ++row) {
      const double value = table_.unit * column.values[row];
      const bool is_finite = std::isfinite(value);
      if (is_finite && holds(range, value)) continue;
      if (++wrong > kToldAtMost) continue;
      const std::string place = fmt::format("{} {}: ", word_of(per_), row + 1);
      const std::string reason =
          is_finite ? shown(value) + " is out of range, it must be " + range_text(range, table_.example)
                    : fmt::format("{:g} is no finite number", column.values[row]);
      errors_.push_back({column.locations[row], path_ + ": " + place + reason});
    }
    if (wrong > kToldAtMost) {
      errors_.back().message += fmt::format("; and {} more numbers are wrong", wrong - kToldAtMost);
    }
  }

  /// Faces that lie on each other are one triangle of the wall, which has one value.
  void check_doubled(const PlacedColumn& column) {
    for (const auto& [first, second] : per_ == TablePer::kVertex ? order_.doubled_vertices : order_.doubled_faces) {
      const double a = column.values[first], b = column.values[second];
      if (std::abs(a - b) <= kRounding * std::max(std::abs(a), std::abs(b))) continue;
      errors_.push_back({column.locations[second],
                         fmt::format("{}: faces of the mesh file lie on each other, but {} {} has {} and {} {} has {}; "
                                     "give both the same or remove one of the faces",
                                     path_, word_of(per_), first + 1, shown(table_.unit * a), word_of(per_), second + 1,
                                     shown(table_.unit * b))});
      return;
    }
  }

  /// "bodies.organ.wall.thickness: `h` of 41 vertices: 0.8 mm to 1.2 mm"
  void describe(const std::vector<PlacedColumn>& columns) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::vector<double>& values = columns[c].values;
      if (values.empty()) continue;
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      notes_.push_back(fmt::format("{}: {} of {}: {} to {}", path_, in_backticks(table_.columns[c]),
                                   counted_rows(values.size(), per_), shown(table_.unit * *low),
                                   shown(table_.unit * *high)));
    }
  }

  CornerNumbers at_corners(const PlacedColumn& column) const {
    CornerNumbers numbers;
    for (std::size_t t = 0; t < order_.face_rows.size(); ++t) {
      const int face = order_.face_rows[t];
      const std::array<int, 3> rows =
          per_ == TablePer::kVertex ? order_.corner_rows[t] : std::array<int, 3>{face, face, face};
      std::array<double, 3> corners{};
      for (int k = 0; k < 3; ++k) corners[k] = table_.unit * column.values[rows[k]];
      numbers.push_back(corners);
    }
    return numbers;
  }

  void throw_errors() {
    if (!errors_.empty()) throw InputErrors(std::move(errors_));
  }

  const FieldTable& table_;
  const TableOrder& order_;
  const std::filesystem::path mesh_file_;  // "" of a shape
  const std::string& path_;
  const SourceLocation& location_;
  TablePer per_ = TablePer::kVertex;
  std::vector<Diagnostic> errors_;
  std::vector<std::string> notes_;
};

}  // namespace

std::vector<CornerNumbers> TableFields::read(const FieldTable& table, const std::vector<Range>& ranges,
                                             const std::string& path, const SourceLocation& location) {
  if (!order_) order_ = table_order(source_, wall_, path, location);
  const auto* mesh = std::get_if<MeshFileSource>(&source_);
  TableReading reading(table, *order_, mesh == nullptr ? "" : mesh->file, path, location);
  std::vector<CornerNumbers> numbers = reading.run(ranges);
  notes_.insert(notes_.end(), reading.notes().begin(), reading.notes().end());
  return numbers;
}

}  // namespace thinwall
