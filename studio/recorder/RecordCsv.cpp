#include "studio/recorder/RecordCsv.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "engine/simulation/SimulationFailure.hpp"
#include "studio/record/RecordColumns.hpp"

namespace thinwall {
namespace {

std::string shortest(double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

/// A text as a field of a CSV line (RFC 4180).
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"') quoted += '"';
    quoted += letter;
  }
  return quoted + '"';
}

void append_number(std::string& row, std::string_view column, double value, const std::string& owner, double time) {
  if (!std::isfinite(value)) {
    throw SimulationFailure(std::string(column) + " of " + owner + " is not a finite number at time " + shortest(time) +
                            " s");
  }
  row += ',';
  row += shortest(value);
}

template <typename Columns>
std::string header(std::string line, const Columns& columns) {
  for (const auto& column : columns) {
    line += ',';
    line += column.name;
  }
  return line;
}

}  // namespace

std::string forces_csv_header() {
  return header("time_s,tool,phase", kToolColumns);
}
std::string body_csv_header() {
  return header("time_s,body", kBodyColumns);
}

std::string points_csv_header() {
  return "time_s,body,point,x_m,y_m,z_m,ux_m,uy_m,uz_m";
}

std::string chambers_csv_header() {
  return "time_s,body,chamber,volume_m3,fluid_volume_m3,leaked_m3,pressure_Pa";
}

std::string forces_csv_rows(const StepRecord& record) {
  std::string rows;
  for (ToolRecord tool : record.tools) {
    rows += shortest(record.time) + ',' + field(tool.tool) + ',' + field(tool.phase);
    for (const ToolColumn& column : kToolColumns) {
      append_number(rows, column.name, column.value(tool), tool.tool, record.time);
    }
    rows += '\n';
  }
  return rows;
}

std::string body_csv_rows(const StepRecord& record) {
  std::string rows;
  for (const BodyRecord& body : record.bodies) {
    rows += shortest(record.time) + ',' + field(body.body);
    for (const BodyColumn& column : kBodyColumns) {
      append_number(rows, column.name, column.get(body), body.body, record.time);
    }
    rows += '\n';
  }
  return rows;
}

std::string points_csv_rows(const StepRecord& record) {
  constexpr std::array<std::string_view, 3> kPositions = {"x_m", "y_m", "z_m"};
  constexpr std::array<std::string_view, 3> kDisplacements = {"ux_m", "uy_m", "uz_m"};
  std::string rows;
  for (const PointRecord& point : record.points) {
    rows += shortest(record.time) + ',' + field(point.body) + ',' + field(point.point);
    const Eigen::Vector3d displacement = point.displacement();
    for (int i = 0; i < 3; ++i) append_number(rows, kPositions[i], point.position[i], point.point, record.time);
    for (int i = 0; i < 3; ++i) append_number(rows, kDisplacements[i], displacement[i], point.point, record.time);
    rows += '\n';
  }
  return rows;
}

std::string chambers_csv_rows(const StepRecord& record) {
  std::string rows;
  for (const ChamberRecord& chamber : record.chambers) {
    rows += shortest(record.time) + ',' + field(chamber.body) + ',' + field(chamber.chamber);
    const auto add = [&](std::string_view column, double value) {
      append_number(rows, column, value, chamber.chamber, record.time);
    };
    add("volume_m3", chamber.volume);
    add("fluid_volume_m3", chamber.fluid_volume);
    add("leaked_m3", chamber.leaked);
    add("pressure_Pa", chamber.pressure);
    rows += '\n';
  }
  return rows;
}

void RecordCsv::Table::write(const std::string& rows) {
  if (!rows.empty() && !text) {
    text.emplace(file);
    text->write(header + '\n');
  }
  if (text) text->write(rows);
}

RecordCsv::RecordCsv(const std::filesystem::path& folder)
    : forces_(folder / "forces.csv"),
      body_(folder / "body.csv"),
      points_{folder / "points.csv", points_csv_header()},
      chambers_{folder / "chambers.csv", chambers_csv_header()} {
  forces_.write(forces_csv_header() + '\n');
  body_.write(body_csv_header() + '\n');
}

void RecordCsv::write(const StepRecord& record) {
  // All before any is written, so that a step that is refused is in none.
  const std::string forces_rows = forces_csv_rows(record);
  const std::string body_rows = body_csv_rows(record);
  const std::string points_rows = points_csv_rows(record);
  const std::string chambers_rows = chambers_csv_rows(record);
  points_.write(points_rows);
  chambers_.write(chambers_rows);
  forces_.write(forces_rows);
  body_.write(body_rows);
}

void RecordCsv::finish() {
  forces_.finish();
  body_.finish();
  for (Table* table : {&points_, &chambers_}) {
    if (table->text) table->text->finish();
  }
}

}  // namespace thinwall
