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

RecordCsv::RecordCsv(const std::filesystem::path& folder) : forces_(folder / "forces.csv"), body_(folder / "body.csv") {
  forces_.write(forces_csv_header() + '\n');
  body_.write(body_csv_header() + '\n');
}

void RecordCsv::write(const StepRecord& record) {
  // Both before either is written, so that a step that is refused is in neither.
  const std::string forces_rows = forces_csv_rows(record);
  const std::string body_rows = body_csv_rows(record);
  forces_.write(forces_rows);
  body_.write(body_rows);
}

void RecordCsv::finish() {
  forces_.finish();
  body_.finish();
}

}  // namespace thinwall
