#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studio/organs/PlyCursor.hpp"

namespace thinwall {

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };

struct PlyHeaderProperty {
  std::string name;
  PlyType type = {};
  std::optional<PlyType> count_type = {};  // of a list
};

struct PlyHeaderElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyHeaderProperty> properties = {};
  int line = 1;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyHeaderElement> elements = {};
};

/// Reads the lines up to `end_header`. Throws FileFormatError at the line: anything that the format does not know,
/// names that are there twice, more than 64 elements or 256 properties of one.
PlyHeader read_ply_header(PlyCursor& cursor);

}  // namespace thinwall
