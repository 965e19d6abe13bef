#include "studio/organs/CsvTable.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "studio/organs/SurfaceOrigin.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char character) {
  return character == ' ' || character == '\t' || character == '\r';
}

struct Cell {
  std::string text;
  int column = 1;
};

class CsvReader {
 public:
  CsvReader(const std::filesystem::path& file, const std::string& bytes, const CsvLimits& limits)
      : file_(file), left_(bytes), limits_(limits) {
    if (left_.starts_with(kByteOrderMark)) left_.remove_prefix(kByteOrderMark.size());
  }

  std::vector<CsvColumn> read(const std::vector<std::string>& names) {
    const std::vector<Cell> header = next_cells();
    if (header.size() == 1 && header[0].text.empty()) refuse(1, "the first line must name the columns, but is empty");
    std::vector<std::size_t> wanted;
    for (const std::string& name : names) wanted.push_back(find(header, name));
    std::vector<CsvColumn> columns(names.size());
    while (!rest_is_blank()) {
      const std::vector<Cell> cells = next_cells();
      check_count(cells, header);
      if ((columns[0].values.size() + 1) * names.size() > limits_.numbers) {
        refuse(1, fmt::format("it holds more than {} numbers, which is the most that is read", limits_.numbers));
      }
      for (std::size_t k = 0; k < wanted.size(); ++k) add(cells[wanted[k]], names[k], columns[k]);
    }
    return columns;
  }

 private:
  [[noreturn]] void refuse(int column, const std::string& message) const {
    throw FileFormatError(file_, line_, column, message);
  }

  bool rest_is_blank() const { return left_.find_first_not_of(" \t\r\n") == std::string_view::npos; }

  std::vector<Cell> next_cells() {
    ++line_;
    const std::size_t end = std::min(left_.find('\n'), left_.size());
    const std::string_view line = left_.substr(0, end);
    left_.remove_prefix(std::min(end + 1, left_.size()));
    std::vector<Cell> cells;
    for (std::size_t at = 0;; ++at) {
      cells.push_back(next_cell(line, at));
      if (at >= line.size()) return cells;
    }
  }

  /// Leaves `at` on the comma, or at the end of the line.
  Cell next_cell(std::string_view line, std::size_t& at) const {
    while (at < line.size() && is_blank(line[at])) ++at;
    Cell cell{.text = "", .column = static_cast<int>(at) + 1};
    if (at < line.size() && line[at] == '"') {
      for (++at;; ++at) {
        if (at >= line.size()) refuse(cell.column, "a quotation mark is not closed in its line");
        if (line[at] == '"' && (at + 1 >= line.size() || line[at + 1] != '"')) break;
        if (line[at] == '"') ++at;
        cell.text += line[at];
      }
      for (++at; at < line.size() && line[at] != ','; ++at) {
        if (!is_blank(line[at])) refuse(static_cast<int>(at) + 1, "expected a comma after the closing quotation mark");
      }
      return cell;
    }
    const std::size_t end = std::min(line.find(',', at), line.size());
    std::string_view text = line.substr(at, end - at);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    cell.text = text;
    at = end;
    return cell;
  }

  std::size_t find(const std::vector<Cell>& header, const std::string& name) const {
    std::vector<std::string> known;
    std::size_t found = header.size();
    for (std::size_t k = 0; k < header.size(); ++k) {
      known.push_back(header[k].text);
      if (header[k].text != name) continue;
      if (found != header.size()) {
        refuse(header[k].column, "there are two columns " + in_backticks(name) + "; give one another name");
      }
      found = k;
    }
    if (found == header.size()) {
      const bool has_semicolons = header.size() == 1 && header[0].text.find(';') != std::string::npos;
      refuse(1, "there is no column " + in_backticks(name) + did_you_mean(name, known) + "; there is " +
                    list_in_backticks(known) +
                    (has_semicolons ? "; columns are parted by commas, not semicolons" : ""));
    }
    return found;
  }

  void check_count(const std::vector<Cell>& cells, const std::vector<Cell>& header) const {
    if (cells.size() == 1 && cells[0].text.empty() && header.size() > 1) {
      refuse(1, "an empty line between rows; remove it");
    }
    if (cells.size() != header.size()) {
      refuse(cells.back().column, fmt::format("{} in a table with {}", counted(cells.size(), "cell", "cells"),
                                              counted(header.size(), "column", "columns")));
    }
  }

  void add(const Cell& cell, const std::string& name, CsvColumn& column) const {
    const std::string_view text = cell.text;
    double value = 0;
    const char* first = text.data() + (text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
    const char* last = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(first, last, value);
    if (failure != std::errc() || stop != last || !std::isfinite(value)) {
      const std::string got = text.empty()
                                  ? "nothing; every row needs one"
                                  : in_backticks(text) + "; write plain numbers like 0.8 or 8e-4, without units";
      refuse(cell.column, "expected a finite number in the column " + in_backticks(name) + ", got " + got);
    }
    column.values.push_back(value);
    column.lines.push_back(line_);
    column.columns.push_back(cell.column);
  }

  const std::filesystem::path& file_;
  std::string_view left_;
  const CsvLimits& limits_;
  int line_ = 0;
};

}  // namespace

std::vector<CsvColumn> read_csv_columns(const std::filesystem::path& file, const std::vector<std::string>& names,
                                        const CsvLimits& limits) {
  const std::string bytes = read_file_bytes(file, limits.file_bytes);
  return CsvReader(file, bytes, limits).read(names);
}

}  // namespace thinwall
