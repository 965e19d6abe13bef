#include "studio/organs/PlyFile.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studio/organs/PlyHeader.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

class BodyReader {
 public:
  BodyReader(PlyCursor& cursor, const PlyHeader& header, const PlyLimits& limits)
      : cursor_(cursor), header_(header), limits_(limits) {}

  PlyFile read() {
    if (header_.format != PlyFormat::kAscii) cursor_.begin_binary();
    for (const PlyHeaderElement& element : header_.elements) {
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
  double number(const PlyType& type) {
    if (header_.format == PlyFormat::kAscii) return cursor_.ascii_number();
    return cursor_.binary_number(type, header_.format == PlyFormat::kBigEndian);
  }

  /// Refuses counts that the rest of the file cannot hold before anything is made for them.
  void check_count(const PlyHeaderElement& element) {
    std::size_t least = 0;  // bytes of one
    for (const PlyHeaderProperty& property : element.properties) {
      const PlyType& type = property.count_type ? *property.count_type : property.type;
      least += header_.format == PlyFormat::kAscii ? 2 : type.bytes;
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

  std::size_t list_length(const PlyHeaderProperty& property) {
    const double length = number(*property.count_type);
    const std::size_t least = header_.format == PlyFormat::kAscii ? 2 : property.type.bytes;
    if (!(length >= 0) || length != std::floor(length) || length > static_cast<double>((cursor_.left() + 1) / least)) {
      cursor_.refuse_last(fmt::format("a list cannot have {:g} items here", length));
    }
    return static_cast<std::size_t>(length);
  }

  void skip_list(const PlyHeaderProperty& property) {
    const std::size_t length = list_length(property);
    for (std::size_t i = 0; i < length; ++i) number(property.type);
  }

  void skip(const PlyHeaderElement& element) {
    for (std::size_t row = 0; row < element.count; ++row) {
      for (const PlyHeaderProperty& property : element.properties) {
        property.count_type ? skip_list(property) : static_cast<void>(number(property.type));
      }
    }
  }

  void note_line(std::vector<int>& lines) {
    if (header_.format != PlyFormat::kAscii) return;
    cursor_.skip_space();
    lines.push_back(cursor_.line());
  }

  static PlyProperty* find(std::vector<PlyProperty>& properties, const std::string& name) {
    const auto row = std::ranges::find_if(properties, [&](const PlyProperty& own) { return own.name == name; });
    return row == properties.end() ? nullptr : &*row;
  }

  void read_vertices(const PlyHeaderElement& element) {
    std::vector<PlyProperty>& properties = ply_.vertex_properties;
    read_rows(element, properties, ply_.vertex_lines, [&](const PlyHeaderProperty& property) { skip_list(property); });
    ply_.vertices.resize(element.count);
    for (const int axis : {0, 1, 2}) {
      const std::string name(1, "xyz"[axis]);
      const PlyProperty* coordinates = find(properties, name);
      if (coordinates == nullptr) cursor_.refuse("the vertices lack the property " + in_backticks(name));
      for (std::size_t v = 0; v < element.count; ++v) ply_.vertices[v][axis] = coordinates->values[v];
      std::erase_if(properties, [&](const PlyProperty& own) { return own.name == name; });
    }
  }

  void read_faces(const PlyHeaderElement& element) {
    read_rows(element, ply_.face_properties, ply_.face_lines, [&](const PlyHeaderProperty& property) {
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
  void read_rows(const PlyHeaderElement& element, std::vector<PlyProperty>& properties, std::vector<int>& lines,
                 const ReadList& read_list) {
    for (const PlyHeaderProperty& property : element.properties) {
      if (!property.count_type) properties.push_back({property.name, {}});
    }
    // A row takes memory of its own besides its numbers.
    take(element.count * (1 + properties.size()));
    for (std::size_t row = 0; row < element.count; ++row) {
      note_line(lines);
      std::size_t column = 0;
      for (const PlyHeaderProperty& property : element.properties) {
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

  PlyCursor& cursor_;
  const PlyHeader& header_;
  const PlyLimits& limits_;
  PlyFile ply_;
  std::size_t numbers_ = 0;
};

}  // namespace

PlyFile read_ply(const std::filesystem::path& file, const PlyLimits& limits) {
  const std::string bytes = read_file_bytes(file, limits.file_bytes);
  PlyCursor cursor(file, bytes);
  const PlyHeader header = read_ply_header(cursor);
  return BodyReader(cursor, header, limits).read();
}

}  // namespace thinwall
