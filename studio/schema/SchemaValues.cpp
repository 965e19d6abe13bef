#include "studio/schema/SchemaSections.hpp"

namespace thinwall {

ValueSchema text_value() {
  return {.kind = ValueKind::kText};
}
ValueSchema path_value() {
  return {.kind = ValueKind::kPath};
}
ValueSchema name_value() {
  return {.kind = ValueKind::kName};
}
ValueSchema boolean_value() {
  return {.kind = ValueKind::kBoolean};
}
ValueSchema direction_value() {
  return {.kind = ValueKind::kDirection};
}

ValueSchema word_value(std::vector<std::string> words) {
  return {.kind = ValueKind::kWord, .words = std::move(words)};
}

ValueSchema integer_value(int minimum, int maximum, const std::string& example) {
  return {.kind = ValueKind::kInteger,
          .range = {.minimum = static_cast<double>(minimum), .maximum = static_cast<double>(maximum)},
          .example = example};
}

ValueSchema quantity_value(const Dimension& dimension, const Range& range, const std::string& example) {
  return {.kind = ValueKind::kQuantity,
          .dimension = dimension,
          .range = range,
          .example = example.empty() ? dimension_example(dimension) : example};
}

ValueSchema vector_value(const Dimension& dimension, const Range& range, const std::string& example) {
  ValueSchema vector = list_value(quantity_value(dimension, range), 3);
  vector.maximum_items = 3;
  vector.example = example;
  return vector;
}

ValueSchema list_value(ValueSchema item, std::size_t minimum_items) {
  ValueSchema list{.kind = ValueKind::kList, .minimum_items = minimum_items};
  list.item.push_back(std::move(item));
  return list;
}

ValueSchema tuple_value(std::vector<ValueSchema> items) {
  ValueSchema list{.kind = ValueKind::kList, .minimum_items = items.size(), .maximum_items = items.size()};
  for (const ValueSchema& item : items) list.example += (list.example.empty() ? "[" : ", ") + item.example;
  list.example += "]";
  list.item = std::move(items);
  return list;
}

ValueSchema usually(ValueSchema value, const UsualRange& usual) {
  (value.kind == ValueKind::kList ? value.item[0] : value).usual = &usual;
  return value;
}

ValueSchema mapping_value(std::vector<MappingSchema> alternatives) {
  return {.kind = ValueKind::kMapping, .mappings = std::move(alternatives)};
}

ValueSchema named_value(MappingSchema mapping, std::size_t minimum_items) {
  ValueSchema named{.kind = ValueKind::kNamedMappings, .minimum_items = minimum_items};
  named.mappings.push_back(std::move(mapping));
  return named;
}

}  // namespace thinwall
