#include "studio/organs/PlyCursor.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

constexpr std::size_t kLongestHeader = 64u << 10;  // bytes

template <typename Number>
Number as(const std::array<char, 8>& raw) {
  Number number;
  std::memcpy(&number, raw.data(), sizeof(Number));
  return number;
}

}  // namespace

void PlyCursor::refuse(const std::string& message) const {
  throw FileFormatError(file_, is_binary_ ? body_line_ : line_, is_binary_ ? 1 : column_,
                        is_binary_ ? fmt::format("at byte {}: {}", at_ + 1, message) : message);
}

void PlyCursor::refuse_last(const std::string& message) {
  column_ = last_column_;
  refuse(message);
}

void PlyCursor::refuse_header(const std::string& message) const {
  throw FileFormatError(file_, line_of_words_, 1, message);
}

void PlyCursor::refuse_row(const std::vector<int>& lines, std::size_t row, const std::string& message) const {
  if (is_binary_) throw FileFormatError(file_, body_line_, 1, message);
  throw FileFormatError(file_, lines[row], 1, message);
}

void PlyCursor::begin_binary() {
  is_binary_ = true;
  body_line_ = line_;
}

std::vector<std::string> PlyCursor::header_words() {
  const std::size_t end = bytes_.find('\n', at_);
  if (end == std::string::npos || end > kLongestHeader) {
    refuse("the header has no line `end_header`; the file is cut off or is no PLY file");
  }
  line_of_words_ = line_;
  std::vector<std::string> words(1);
  for (const char character : std::string_view(bytes_).substr(at_, end - at_)) {
    const bool is_space = character == ' ' || character == '\t' || character == '\r';
    if (!is_space) words.back() += character;
    if (is_space && !words.back().empty()) words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  at_ = end + 1;
  ++line_;
  return words;
}

double PlyCursor::ascii_number() {
  skip_space();
  const std::size_t end = std::min(bytes_.find_first_of(" \t\r\n", at_), bytes_.size());
  if (end == at_) refuse("the file ends before all that its header announces");
  const std::string_view word = std::string_view(bytes_).substr(at_, end - at_);
  double number = 0;
  const char* first = word.data() + (word.starts_with('+') && !word.starts_with("+-") ? 1 : 0);
  const auto [stop, failure] = std::from_chars(first, word.data() + word.size(), number);
  if (failure != std::errc() || stop != word.data() + word.size()) {
    refuse("expected a number, got " + in_backticks(word));
  }
  last_column_ = column_;
  column_ += static_cast<int>(end - at_);
  at_ = end;
  return number;
}

void PlyCursor::skip_space() {
  while (at_ < bytes_.size() && std::strchr(" \t\r\n", bytes_[at_]) != nullptr && bytes_[at_] != '\0') {
    const bool is_end = bytes_[at_++] == '\n';
    line_ += is_end ? 1 : 0;
    column_ = is_end ? 1 : column_ + 1;
  }
}

double PlyCursor::binary_number(const PlyType& type, bool is_big) {
  if (left() < type.bytes) refuse("the file ends before all that its header announces");
  std::array<char, 8> raw{};
  std::memcpy(raw.data(), bytes_.data() + at_, type.bytes);
  if (is_big != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.begin() + type.bytes);
  at_ += type.bytes;
  switch (type.type) {
    case PlyNumber::kInt8:
      return as<std::int8_t>(raw);
    case PlyNumber::kUint8:
      return as<std::uint8_t>(raw);
    case PlyNumber::kInt16:
      return as<std::int16_t>(raw);
    case PlyNumber::kUint16:
      return as<std::uint16_t>(raw);
    case PlyNumber::kInt32:
      return as<std::int32_t>(raw);
    case PlyNumber::kUint32:
      return as<std::uint32_t>(raw);
    case PlyNumber::kFloat32:
      return static_cast<double>(as<float>(raw));
    case PlyNumber::kFloat64:
      break;
  }
  return as<double>(raw);
}

}  // namespace thinwall
