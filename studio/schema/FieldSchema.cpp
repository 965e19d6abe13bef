#include "studio/schema/SchemaSections.hpp"

namespace thinwall {
namespace {

constexpr const char* kAsTheKey = "as the key takes without a field";

KeySchema per_key(bool needed, const std::string& documentation) {
  return {"per", word_value({"vertex", "face"}), needed, {}, documentation};
}

/// Beside kAsTheKey: the forms of a table, which the page has at the field itself.
constexpr const char* kOrTable = ", or by `file` or `attribute` as below";

/// The two forms of a field whose numbers stand in a file. `columns` tells their names.
std::vector<MappingSchema> table_forms(const std::string& of, const ValueSchema& columns, const std::string& column_key,
                                       const std::vector<KeySchema>& unit) {
  MappingSchema file{.name = of + " from a file",
                     .documentation =
                         "A table of text, comma-separated (CSV): names in the first line, then a line for "
                         "each vertex or face of the mesh file (PLY, OBJ) or shape, in its order. Not "
                         "with `remesh`, nor where `repair` has changed the mesh."};
  file.keys = {{"file", path_value(), true, {}, "the table"},
               {column_key, columns, true, {}, "named in the first line of the table"}};
  file.keys.insert(file.keys.end(), unit.begin(), unit.end());
  file.keys.push_back(
      per_key(true, "what a line belongs to; a triangle has the mean of its corners or the number of its face"));
  MappingSchema attribute{.name = of + " from the mesh",
                          .documentation = "Properties of the vertices or faces of the body's PLY file."};
  attribute.keys = {{"attribute", columns, true, {}, "named in the header of the mesh file"}};
  attribute.keys.insert(attribute.keys.end(), unit.begin(), unit.end());
  attribute.keys.push_back(per_key(false, "what they belong to; whichever has them when absent"));
  return {file, attribute};
}

/// A list of parts of the wall, each with a value.
KeySchema regions_key(const std::string& of, const std::string& definition, const std::string& key,
                      const ValueSchema& value, const std::string& documentation) {
  MappingSchema part{
      .name = of + " region", .definition = definition, .documentation = "A part of the wall with a value of its own."};
  part.keys = {{"in", region_schema(), true, {}, "where"}, {key, value, true, {}, documentation}};
  return {"regions", list_value(mapping_value({part})), false, "[]", "parts of the wall; a later one wins"};
}

/// By default and by region; `standard` is what the default may be, `value` what a region may have.
MappingSchema region_form(const std::string& of, const std::string& definition, const ValueSchema& standard,
                          const ValueSchema& value) {
  const std::string region = definition.empty() ? "" : "region_of_" + definition;
  MappingSchema field{.name = of, .definition = definition, .documentation = "By parts of the wall."};
  field.keys = {{"default", standard, true, {}, "value where no region says otherwise"},
                regions_key(of, region, "value", value, "value there")};
  return field;
}

void add_forms(ValueSchema& value, const std::vector<MappingSchema>& forms) {
  value.mappings.insert(value.mappings.end(), forms.begin(), forms.end());
}

ValueSchema three_names() {
  ValueSchema names = tuple_value({text_value(), text_value(), text_value()});
  names.example = "[fx, fy, fz]";
  return names;
}

/// Of the stretch in every direction; or of a direction's components, the stretch along it and the one across it.
ValueSchema stretch_names() {
  ValueSchema names = list_value(text_value(), 1);
  names.maximum_items = 5;
  names.single = true;
  names.example = "stretch, or [fx, fy, fz, along, across]";
  names.page_words =
      "a name: stretch in every direction; or five (e.g. [fx, fy, fz, along, across]): a direction, the stretches "
      "along and across it";
  return names;
}

}  // namespace

ValueSchema field_schema(ValueSchema number) {
  const std::string definition =
      "field of " + dimension_name(number.dimension) + " " + range_text(number.range, number.example);
  ValueSchema inner = number;
  inner.page_words = kAsTheKey;
  std::vector<KeySchema> unit;
  if (number.dimension != kDimensionless) {
    ValueSchema value =
        quantity_value(number.dimension, kAboveZero, number.example.substr(number.example.find(' ') + 1));
    value.bare_unit = true;
    value.page_words = "a unit of the key's dimension (e.g. mm), or what 1 stands for (e.g. 0.1 mm)";
    unit = {{"unit", value, true, {}, "unit of the numbers; not for keys without a dimension"}};
  }
  std::vector<MappingSchema> tables = table_forms("field", text_value(), "column", unit);
  tables[0].definition = "table of " + definition;
  ValueSchema standard = number;
  standard.page_words = kAsTheKey;
  standard.page_words += kOrTable;
  standard.mappings = tables;
  number.mappings = {region_form("field", definition, standard, inner)};
  add_forms(number, tables);
  return number;
}

ValueSchema fibres_schema() {
  MappingSchema fibres{.name = "fibres", .documentation = "Where the first axis of the law lies in the wall."};
  fibres.keys = {{"along", direction_value(), true, {}, "direction in space, brought into the plane of each triangle"},
                 regions_key("fibres", "", "along", direction_value(), "direction there")};
  ValueSchema value = mapping_value({fibres});
  add_forms(value, table_forms("fibres", three_names(), "columns", {}));
  return value;
}

ValueSchema prestretch_schema() {
  const ValueSchema number = usually(
      quantity_value(kDimensionless, {.minimum = 0, .maximum = 10, .minimum_excluded = true}, "1.1"), kUsualPrestretch);
  ValueSchema pair = list_value(number, 2);
  pair.maximum_items = 2;
  pair.example = "[1.2, 1.05]";
  MappingSchema directed{.name = "prestretch by direction", .documentation = "Different along and across a direction."};
  directed.keys = {
      {"along", direction_value(), true, {}, "direction in space, brought into the plane of each triangle"},
      {"values", pair, true, {}, "stretches along it and across it"}};
  ValueSchema inner = number;
  inner.mappings = {directed};
  const std::vector<MappingSchema> tables = table_forms("prestretch field", stretch_names(), "column", {});
  ValueSchema standard = inner;
  standard.mappings[0].definition = "prestretch default";
  standard.page_words = "a number or by direction, like `value` of a region" + std::string(kOrTable);
  add_forms(standard, tables);
  ValueSchema value = number;
  value.mappings = {region_form("prestretch field", "", standard, inner), directed};
  add_forms(value, tables);
  return value;
}

}  // namespace thinwall
