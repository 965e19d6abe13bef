#include "studio/scenario/SchemaSections.hpp"

namespace thinwall {
namespace {

constexpr const char* kAsTheKey = "as the key takes without a field";

/// A list of parts of the wall, each with a value.
KeySchema regions_key(const std::string& of, const std::string& definition, const std::string& key,
                      const ValueSchema& value, const std::string& documentation) {
  MappingSchema part{
      .name = of + " region", .definition = definition, .documentation = "A part of the wall with a value of its own."};
  part.keys = {{"in", region_schema(), true, {}, "where"}, {key, value, true, {}, documentation}};
  return {"regions", list_value(mapping_value({part})), false, "[]", "parts of the wall; a later one wins"};
}

/// By default and by region.
MappingSchema region_form(const std::string& of, const std::string& definition, const ValueSchema& value) {
  const std::string region = definition.empty() ? "" : "region_of_" + definition;
  MappingSchema field{.name = of, .definition = definition, .documentation = "By parts of the wall."};
  field.keys = {{"default", value, true, {}, "value where no region says otherwise"},
                regions_key(of, region, "value", value, "value there")};
  return field;
}

}  // namespace

ValueSchema field_schema(ValueSchema number) {
  const std::string definition =
      "field of " + dimension_name(number.dimension) + " " + range_text(number.range, number.example);
  ValueSchema inner = number;
  inner.page_words = kAsTheKey;
  number.mappings = {region_form("field", definition, inner)};
  return number;
}

ValueSchema fibres_schema() {
  MappingSchema fibres{.name = "fibres", .documentation = "Where the first axis of the law lies in the wall."};
  fibres.keys = {{"along", direction_value(), true, {}, "direction in space, brought into the plane of each triangle"},
                 regions_key("fibres", "", "along", direction_value(), "direction there")};
  return mapping_value({fibres});
}

ValueSchema prestretch_schema() {
  const ValueSchema number =
      quantity_value(kDimensionless, {.minimum = 0, .maximum = 10, .minimum_excluded = true}, "1.1");
  ValueSchema pair = list_value(number, 2);
  pair.maximum_items = 2;
  pair.example = "[1.2, 1.05]";
  MappingSchema directed{.name = "prestretch by direction", .documentation = "Different along and across a direction."};
  directed.keys = {
      {"along", direction_value(), true, {}, "direction in space, brought into the plane of each triangle"},
      {"values", pair, true, {}, "stretches along it and across it"}};
  ValueSchema inner = number;
  inner.mappings = {directed};
  ValueSchema value = number;
  value.mappings = {region_form("prestretch field", "", inner), directed};
  return value;
}

}  // namespace thinwall
