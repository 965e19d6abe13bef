#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "studio/organs/FileFormatError.hpp"

namespace thinwall {

/// How a number is stored.
enum class PlyNumber { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct PlyType {
  std::string_view word;
  PlyNumber type;
  std::size_t bytes;
};

/// The bytes of the file and how far they are read.
class PlyCursor {
 public:
  /// Both stay where they are while the cursor lives.
  PlyCursor(const std::filesystem::path& file, const std::string& bytes) : file_(file), bytes_(bytes) {}

  /// The words of the next line of the header.
  std::vector<std::string> header_words();
  void begin_binary();

  void skip_space();  // and the ends of lines
  /// The next number. Both throw FileFormatError: what stands there is none, the file ends.
  double ascii_number();
  double binary_number(const PlyType& type, bool is_big);

  std::size_t left() const { return bytes_.size() - at_; }  // bytes
  int line() const { return line_; }

  /// Each throws FileFormatError: where the cursor stands, at the number that was read last, at the line of the header
  /// that was read last, at a row of which `lines` has the line in an ascii file.
  [[noreturn]] void refuse(const std::string& message) const;
  [[noreturn]] void refuse_last(const std::string& message);
  [[noreturn]] void refuse_header(const std::string& message) const;
  [[noreturn]] void refuse_row(const std::vector<int>& lines, std::size_t row, const std::string& message) const;

 private:
  const std::filesystem::path& file_;
  const std::string& bytes_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  int last_column_ = 1;
  int line_of_words_ = 1;
  int body_line_ = 1;
  bool is_binary_ = false;
};

}  // namespace thinwall
