#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "studio/organs/FileFormatError.hpp"

namespace thinwall {

/// A column of numbers. The places are those of the cells in the file; lines and columns count from 1.
struct CsvColumn {
  std::vector<double> values;  // (rows), finite
  std::vector<int> lines;      // (rows)
  std::vector<int> columns;    // (rows), of the first character
};

struct CsvLimits {
  std::uintmax_t file_bytes = 256u << 20;
  std::size_t numbers = 10'000'000;  // in the columns that are read
};

/// Reads columns of a table of comma-separated values: names in the first line, then a line for each row; a cell may
/// stand in quotation marks, empty lines at the end count for nothing. Gives the columns in the order of `names`.
/// Throws FileFormatError at the cell: missing, over a limit, no such column or twice, a line with more or fewer cells
/// than the first, a cell that is no finite number, an empty line between rows.
std::vector<CsvColumn> read_csv_columns(const std::filesystem::path& file, const std::vector<std::string>& names,
                                        const CsvLimits& limits = {});

}  // namespace thinwall
