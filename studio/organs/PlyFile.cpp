#include "studio/organs/PlyFile.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

#include "studio/scenario/Wording.hpp"

namespace thinwall {
namespace {

constexpr std::size_t kLongestHeader = 64u << 10;  // bytes
constexpr std::size_t kMostElements = 64;
constexpr std::size_t kMostProperties = 256;

enum class Format { kAscii, kLittleEndian, kBigEndian };
enum class NumberType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct TypeWord {
  std::string_view word;
  NumberType type;
  std::size_t bytes;
};

constexpr std::array<TypeWord, 16> kTypes = {{{"char", NumberType::kInt8, 1},
                                              {"int8", NumberType::kInt8, 1},
                                              {"uchar", NumberType::kUint8, 1},
                                              {"uint8", NumberType::kUint8, 1},
                                              {"short", NumberType::kInt16, 2},
                                              {"int16", NumberType::kInt16, 2},
                                              {"ushort", NumberType::kUint16, 2},
                                              {"uint16", NumberType::kUint16, 2},
                                              {"int", NumberType::kInt32, 4},
                                              {"int32", NumberType::kInt32, 4},
                                              {"uint", NumberType::kUint32, 4},
                                              {"uint32", NumberType::kUint32, 4},
                                              {"float", NumberType::kFloat32, 4},
                                              {"float32", NumberType::kFloat32, 4},
                                              {"double", NumberType::kFloat64, 8},
                                              {"float64", NumberType::kFloat64, 8}}};

struct HeaderProperty {
  std::string name;
  TypeWord type = {};
  std::optional<TypeWord> count_type = {};  // of a list
};

struct HeaderElement {
  std::string name;
  std::size_t count = 0;
  std::vector<HeaderProperty> properties = {};
  int line = 1;
};

struct Header {
  Format format = Format::kAscii;
  std::vector<HeaderElement> elements = {};
};

/// The bytes of the file and how far they are read.
class Cursor {
 public:
  Cursor(const std::filesystem::path& file, const std::string& bytes) : file_(file), bytes_(bytes) {}

  [[noreturn]] void refuse(const std::string& message) const {
    throw FileFormatError(file_, is_binary_ ? body_line_ : line_, is_binary_ ? 1 : column_,
                          is_binary_ ? fmt::format("at byte {}: {}", at_ + 1, message) : message);
  }

  void begin_binary() {
    is_binary_ = true;
    body_line_ = line_;
  }

  std::size_t left() const { return bytes_.size() - at_; }
  int line() const { return line_; }

  /// The words of the next line of the header.
  std::vector<std::string> header_words() {
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

  /// Refuses a row of an ascii file by its line.
  [[noreturn]] void refuse_row(const std::vector<int>& lines, std::size_t row, const std::string& message) const {
    if (is_binary_) throw FileFormatError(file_, body_line_, 1, message);
    throw FileFormatError(file_, lines[row], 1, message);
  }

  /// Refuses the number that was read last.
  [[noreturn]] void refuse_last(const std::string& message) {
    column_ = last_column_;
    refuse(message);
  }

  [[noreturn]] void refuse_header(const std::string& message) const {
    throw FileFormatError(file_, line_of_words_, 1, message);
  }

  double ascii_number() {
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

  void skip_space() {
    while (at_ < bytes_.size() && std::strchr(" \t\r\n", bytes_[at_]) != nullptr && bytes_[at_] != '\0') {
      const bool is_end = bytes_[at_++] == '\n';
      line_ += is_end ? 1 : 0;
      column_ = is_end ? 1 : column_ + 1;
    }
  }

  double binary_number(const TypeWord& type, bool is_big) {
    if (left() < type.bytes) refuse("the file ends before all that its header announces");
    std::array<char, 8> raw{};
    std::memcpy(raw.data(), bytes_.data() + at_, type.bytes);
    if (is_big != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.begin() + type.bytes);
    at_ += type.bytes;
    switch (type.type) {
      case NumberType::kInt8:
        return as<std::int8_t>(raw);
      case NumberType::kUint8:
        return as<std::uint8_t>(raw);
      case NumberType::kInt16:
        return as<std::int16_t>(raw);
      case NumberType::kUint16:
        return as<std::uint16_t>(raw);
      case NumberType::kInt32:
        return as<std::int32_t>(raw);
      case NumberType::kUint32:
        return as<std::uint32_t>(raw);
      case NumberType::kFloat32:
        return static_cast<double>(as<float>(raw));
      case NumberType::kFloat64:
        break;
    }
    return as<double>(raw);
  }

 private:
  template <typename Number>
  static Number as(const std::array<char, 8>& raw) {
    Number number;
    std::memcpy(&number, raw.data(), sizeof(Number));
    return number;
  }

  const std::filesystem::path& file_;
  const std::string& bytes_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  int last_column_ = 1;
  int line_of_words_ = 1;
  int body_line_ = 1;
  bool is_binary_ = false;
};

class HeaderReader {
 public:
  explicit HeaderReader(Cursor& cursor) : cursor_(cursor) {}

  Header read() {
    const std::vector<std::string> first = cursor_.header_words();
    if (first != std::vector<std::string>{"ply"}) cursor_.refuse_header("a PLY file begins with the line `ply`");
    bool has_format = false;
    for (;;) {
      const std::vector<std::string> words = cursor_.header_words();
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      if (words[0] == "format") {
        read_format(words);
        has_format = true;
      } else if (words[0] == "element") {
        read_element(words);
      } else if (words[0] == "property") {
        read_property(words);
      } else {
        cursor_.refuse_header("the header knows `format`, `element`, `property`, `comment` and `end_header`, not " +
                              in_backticks(words[0]));
      }
    }
    if (!has_format) cursor_.refuse_header("the header lacks the line `format`");
    return std::move(header_);
  }

 private:
  void read_format(const std::vector<std::string>& words) {
    const std::string word = words.size() > 1 ? words[1] : "";
    if (word == "ascii") {
      header_.format = Format::kAscii;
    } else if (word == "binary_little_endian") {
      header_.format = Format::kLittleEndian;
    } else if (word == "binary_big_endian") {
      header_.format = Format::kBigEndian;
    } else {
      cursor_.refuse_header("the format is `ascii`, `binary_little_endian` or `binary_big_endian`, not " +
                            in_backticks(word));
    }
  }

  void read_element(const std::vector<std::string>& words) {
    HeaderElement element{.name = words.size() > 1 ? words[1] : "", .line = cursor_.line() - 1};
    const std::string count = words.size() > 2 ? words[2] : "";
    const auto [stop, failure] = std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (words.size() != 3 || failure != std::errc() || stop != count.data() + count.size()) {
      cursor_.refuse_header("expected `element NAME COUNT`");
    }
    const auto is_same = [&](const HeaderElement& other) { return other.name == element.name; };
    if (std::ranges::any_of(header_.elements, is_same)) {
      cursor_.refuse_header("the element " + in_backticks(element.name) + " is there twice");
    }
    if (header_.elements.size() == kMostElements) cursor_.refuse_header("more than 64 elements");
    header_.elements.push_back(std::move(element));
  }

  TypeWord type_of(const std::string& word) const {
    const auto row = std::ranges::find_if(kTypes, [&](const TypeWord& type) { return type.word == word; });
    if (row == kTypes.end()) cursor_.refuse_header("there is no type of numbers " + in_backticks(word));
    return *row;
  }

  void read_property(const std::vector<std::string>& words) {
    if (header_.elements.empty()) cursor_.refuse_header("a property stands before the first `element`");
    HeaderProperty property;
    if (words.size() == 5 && words[1] == "list") {
      property = {.name = words[4], .type = type_of(words[3]), .count_type = type_of(words[2])};
      if (property.count_type->type >= NumberType::kFloat32) cursor_.refuse_header("a list cannot have broken counts");
    } else if (words.size() == 3) {
      property = {.name = words[2], .type = type_of(words[1])};
    } else {
      cursor_.refuse_header("expected `property TYPE NAME` or `property list TYPE TYPE NAME`");
    }
    std::vector<HeaderProperty>& properties = header_.elements.back().properties;
    const auto is_same = [&](const HeaderProperty& other) { return other.name == property.name; };
    if (std::ranges::any_of(properties, is_same)) {
      cursor_.refuse_header("the property " + in_backticks(property.name) + " is there twice");
    }
    if (properties.size() == kMostProperties) cursor_.refuse_header("more than 256 properties of an element");
    properties.push_back(std::move(property));
  }

  Cursor& cursor_;
  Header header_;
};

class BodyReader {
 public:
  BodyReader(Cursor& cursor, const Header& header, const PlyLimits& limits)
      : cursor_(cursor), header_(header), limits_(limits) {}

  PlyFile read() {
    if (header_.format != Format::kAscii) cursor_.begin_binary();
    for (const HeaderElement& element : header_.elements) {
      check_count(element);
      if (element.name == "vertex") read_vertices(element);
      if (element.name == "face") read_faces(element);
      if (element.name != "vertex" && element.name != "face") skip(element);
    }
    if (ply_.vertices.empty()) cursor_.refuse("the file has no vertices");
    check_corners();
    return std::move(ply_);
  }

 private:
  double number(const TypeWord& type) {
    if (header_.format == Format::kAscii) return cursor_.ascii_number();
    return cursor_.binary_number(type, header_.format == Format::kBigEndian);
  }

  /// Refuses counts that the rest of the file cannot hold before anything is made for them.
  void check_count(const HeaderElement& element) {
    std::size_t least = 0;  // bytes of one
    for (const HeaderProperty& property : element.properties) {
      const TypeWord& type = property.count_type ? *property.count_type : property.type;
      least += header_.format == Format::kAscii ? 2 : type.bytes;
    }
    if (element.properties.empty() && element.count > 0) {
      cursor_.refuse("the element " + in_backticks(element.name) + " has no properties");
    }
    // The last number of a text needs no space after it.
    if (element.count > 0 && element.count > (cursor_.left() + 1) / least) {
      cursor_.refuse(
          fmt::format("the header announces {} of the element {}, more than the file holds; it is cut off "
                      "or malformed",
                      element.count, in_backticks(element.name)));
    }
    if (element.count > static_cast<std::size_t>(std::numeric_limits<int>::max())) cursor_.refuse("too many elements");
  }

  void take(std::size_t count) {
    numbers_ += count;
    if (numbers_ > limits_.numbers) {
      cursor_.refuse(fmt::format("it holds more than {} numbers, which is the most that is read", limits_.numbers));
    }
  }

  std::size_t list_length(const HeaderProperty& property) {
    const double length = number(*property.count_type);
    const std::size_t least = header_.format == Format::kAscii ? 2 : property.type.bytes;
    if (!(length >= 0) || length != std::floor(length) || length > static_cast<double>((cursor_.left() + 1) / least)) {
      cursor_.refuse_last(fmt::format("a list cannot have {:g} items here", length));
    }
    return static_cast<std::size_t>(length);
  }

  void skip_list(const HeaderProperty& property) {
    const std::size_t length = list_length(property);
    for (std::size_t i = 0; i < length; ++i) number(property.type);
  }

  void skip(const HeaderElement& element) {
    for (std::size_t row = 0; row < element.count; ++row) {
      for (const HeaderProperty& property : element.properties) {
        property.count_type ? skip_list(property) : static_cast<void>(number(property.type));
      }
    }
  }

  void note_line(std::vector<int>& lines) {
    if (header_.format != Format::kAscii) return;
    cursor_.skip_space();
    lines.push_back(cursor_.line());
  }

  static PlyProperty* find(std::vector<PlyProperty>& properties, const std::string& name) {
    const auto row = std::ranges::find_if(properties, [&](const PlyProperty& own) { return own.name == name; });
    return row == properties.end() ? nullptr : &*row;
  }

  void read_vertices(const HeaderElement& element) {
    std::vector<PlyProperty>& properties = ply_.vertex_properties;
    read_rows(element, properties, ply_.vertex_lines, [&](const HeaderProperty& property) { skip_list(property); });
    ply_.vertices.resize(element.count);
    for (const int axis : {0, 1, 2}) {
      const std::string name(1, "xyz"[axis]);
      const PlyProperty* coordinates = find(properties, name);
      if (coordinates == nullptr) cursor_.refuse("the vertices lack the property " + in_backticks(name));
      for (std::size_t v = 0; v < element.count; ++v) ply_.vertices[v][axis] = coordinates->values[v];
      std::erase_if(properties, [&](const PlyProperty& own) { return own.name == name; });
    }
  }

  void read_faces(const HeaderElement& element) {
    read_rows(element, ply_.face_properties, ply_.face_lines, [&](const HeaderProperty& property) {
      const bool is_corners = property.name == "vertex_indices" || property.name == "vertex_index";
      if (!is_corners) return skip_list(property);
      const std::size_t length = list_length(property);
      take(length);
      std::vector<int> corners(length);
      for (int& corner : corners) {
        const double index = number(property.type);
        const bool is_index = index >= 0 && index <= std::numeric_limits<int>::max() && index == std::floor(index);
        if (!is_index) cursor_.refuse_last(fmt::format("{:g} is no corner of a face", index));
        corner = static_cast<int>(index);
      }
      ply_.faces.push_back(std::move(corners));
    });
    if (ply_.faces.size() != element.count) {
      cursor_.refuse("the faces lack the list `vertex_indices`, or have it twice");
    }
  }

  template <typename ReadList>
  void read_rows(const HeaderElement& element, std::vector<PlyProperty>& properties, std::vector<int>& lines,
                 const ReadList& read_list) {
    for (const HeaderProperty& property : element.properties) {
      if (!property.count_type) properties.push_back({property.name, {}});
    }
    // A row takes memory of its own besides its numbers.
    take(element.count * (1 + properties.size()));
    for (std::size_t row = 0; row < element.count; ++row) {
      note_line(lines);
      std::size_t column = 0;
      for (const HeaderProperty& property : element.properties) {
        if (property.count_type) {
          read_list(property);
        } else {
          properties[column++].values.push_back(number(property.type));
        }
      }
    }
  }

  void check_corners() const {
    for (std::size_t f = 0; f < ply_.faces.size(); ++f) {
      for (const int corner : ply_.faces[f]) {
        if (corner < static_cast<int>(ply_.vertices.size())) continue;
        cursor_.refuse_row(
            ply_.face_lines, f,
            fmt::format("face {} has the corner {}, but there are {} vertices", f + 1, corner, ply_.vertices.size()));
      }
    }
    for (std::size_t v = 0; v < ply_.vertices.size(); ++v) {
      if (!ply_.vertices[v].allFinite()) {
        cursor_.refuse_row(ply_.vertex_lines, v, fmt::format("a coordinate of vertex {} is no finite number", v + 1));
      }
    }
  }

  Cursor& cursor_;
  const Header& header_;
  const PlyLimits& limits_;
  PlyFile ply_;
  std::size_t numbers_ = 0;
};

}  // namespace

PlyFile read_ply(const std::filesystem::path& file, const PlyLimits& limits) {
  const std::string bytes = read_file_bytes(file, limits.file_bytes);
  Cursor cursor(file, bytes);
  const Header header = HeaderReader(cursor).read();
  return BodyReader(cursor, header, limits).read();
}

}  // namespace thinwall
