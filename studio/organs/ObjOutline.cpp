#include "studio/organs/ObjOutline.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

constexpr std::string_view kBlanks = " \t\r";

class ObjReader {
 public:
  ObjReader(const std::filesystem::path& file, const ObjLimits& limits) : file_(file), limits_(limits) {}

  ObjOutline read(std::string_view bytes) {
    while (!bytes.empty()) {
      const std::size_t end = std::min(bytes.find('\n'), bytes.size());
      ++line_;
      begin_ = bytes.data();
      read_line(bytes.substr(0, end));
      bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    check_corners();
    return std::move(outline_);
  }

 private:
  [[noreturn]] void refuse(std::string_view word, const std::string& message) const {
    throw FileFormatError(file_, line_, static_cast<int>(word.data() - begin_) + 1, message);
  }

  static std::string_view next_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
  }

  void read_line(std::string_view line) {
    const std::string_view keyword = next_word(line);
    if (keyword != "v" && keyword != "f") return;
    const std::size_t last = line.find_last_not_of(kBlanks);
    if (last != std::string_view::npos && line[last] == '\\') {
      refuse(line.substr(last), "a line that is continued by `\\` is not read here; write it in one line");
    }
    keyword == "v" ? read_vertex(line) : read_face(line);
    if (3 * outline_.vertices.size() + corners_ > limits_.numbers) {
      refuse(keyword, fmt::format("it holds more than {} numbers, which is the most that is read", limits_.numbers));
    }
  }

  void read_vertex(std::string_view line) {
    Eigen::Vector3d vertex;
    for (const int axis : {0, 1, 2}) {
      const std::string_view word = next_word(line);
      const char* last = word.data() + word.size();
      const auto [stop, failure] =
          std::from_chars(word.data() + (word.starts_with('+') && !word.starts_with("+-") ? 1 : 0), last, vertex[axis]);
      if (word.empty()) refuse(line, "a vertex has three coordinates");
      if (failure != std::errc() || stop != last || !std::isfinite(vertex[axis])) {
        refuse(word, "expected a finite number, got " + in_backticks(word));
      }
    }
    outline_.vertices.push_back(vertex);
  }

  /// A corner is `7`, `7/1`, `7//3` or `7/1/3`; counted from 1, or back from the last vertex when below zero.
  void read_face(std::string_view line) {
    std::vector<int> corners;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      const char* last = word.data() + std::min(word.find('/'), word.size());
      int index = 0;
      const auto [stop, failure] = std::from_chars(word.data(), last, index);
      const int vertices = static_cast<int>(outline_.vertices.size());
      if (failure != std::errc() || stop != last || index == 0 || index < -vertices) {
        refuse(word, "expected a corner of a face, got " + in_backticks(word));
      }
      corners.push_back(index > 0 ? index - 1 : vertices + index);
    }
    if (corners.size() < 3) refuse(line, "a face has three corners or more");
    corners_ += corners.size();
    face_lines_.push_back(line_);
    outline_.faces.push_back(std::move(corners));
  }

  /// A face may stand before its vertices.
  void check_corners() const {
    for (std::size_t f = 0; f < outline_.faces.size(); ++f) {
      for (const int corner : outline_.faces[f]) {
        if (corner < static_cast<int>(outline_.vertices.size())) continue;
        throw FileFormatError(
            file_, face_lines_[f], 1,
            fmt::format("a face has the corner {}, but there are {} vertices", corner + 1, outline_.vertices.size()));
      }
    }
  }

  const std::filesystem::path& file_;
  const ObjLimits& limits_;
  ObjOutline outline_;
  std::vector<int> face_lines_;  // (faces)
  std::size_t corners_ = 0;
  int line_ = 0;
  const char* begin_ = nullptr;  // of the line
};

}  // namespace

ObjOutline read_obj_outline(const std::filesystem::path& file, const ObjLimits& limits) {
  const std::string bytes = read_file_bytes(file, limits.file_bytes);
  return ObjReader(file, limits).read(bytes);
}

}  // namespace thinwall
