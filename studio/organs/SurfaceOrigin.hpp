#pragma once

#include <string>

#include "studio/scenario/InputError.hpp"

namespace thinwall {

/// What a surface is made from, for messages about it.
struct SurfaceOrigin {
  std::string name;         // "mesh `organs/liver.obj`", "shape `sheet`"
  double unit = 1e-3;       // metres per unit of the coordinates in messages
  std::string unit_name;    // "mm", "units of the file"
  std::string key_path;     // of the `surface`: "bodies.organ.surface"
  SourceLocation location;  // of the `surface`
};

/// "1 edge", "3 edges"
inline std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace thinwall
