#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/mesh/Region.hpp"
#include "studio/scenario/SourceLocation.hpp"
#include "studio/schema/Range.hpp"

namespace thinwall {

enum class TablePer { kVertex, kFace };

/// Numbers for each vertex or face of a surface: from a table of text, or the mesh file's own.
struct FieldTable {
  std::filesystem::path file = {};        // CSV; empty: the properties of the mesh file
  std::vector<std::string> columns = {};  // (1), or (3) of a direction
  std::optional<TablePer> per = {};       // absent: what the mesh file has the properties for
  double unit = 1;                        // SI units per 1 of the table
  Range range = {};                       // of each number, SI
  std::string example = {};               // such a number in the words of a scenario
};

/// A part of the wall with a value of its own.
template <typename Value>
struct FieldRegion {
  Region region = {};
  Value value = {};
  SourceLocation location = {};  // of the region
};

/// What may differ from place to place of a wall.
template <typename Value>
struct Field {
  Value standard = {};                           // where no region says otherwise
  SourceLocation location = {};                  // of `standard`, or of what names the table
  std::vector<FieldRegion<Value>> regions = {};  // a later one wins
  std::optional<FieldTable> table = {};          // instead of `standard`
};

/// Whether all of the wall has the standard value.
template <typename Value>
bool is_uniform(const Field<Value>& field) {
  return field.regions.empty() && !field.table;
}

/// A parameter of the wall's law that differs from place to place.
struct ParameterField {
  std::size_t index = 0;  // into Material::parameters
  std::string path = {};  // in the material: "shear_modulus", "terms[2].modulus"
  Field<double> values = {};
};

}  // namespace thinwall
