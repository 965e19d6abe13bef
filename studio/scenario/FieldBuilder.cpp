#include "studio/scenario/FieldBuilder.hpp"

#include "studio/scenario/CheckedReading.hpp"
#include "studio/scenario/TextNode.hpp"

namespace thinwall {
namespace {

int axis_index(const CheckedValue& axis) {
  return axis.text[0] - 'x';
}

FieldTable to_table(const CheckedValue& value) {
  FieldTable table{.range = value.range, .example = value.example};
  const CheckedValue* names = value.find("attribute");
  if (const CheckedValue* file = value.find("file")) {
    table.file = file->text;
    names = value.find("column") != nullptr ? value.find("column") : value.find("columns");
  }
  if (names->kind == CheckedKind::kText) table.columns.push_back(names->text);
  for (const CheckedValue& name : names->items) table.columns.push_back(name.text);
  if (const CheckedValue* unit = value.find("unit")) table.unit = unit->number;
  if (const CheckedValue* per = value.find("per")) {
    table.per = per->text == "face" ? TablePer::kFace : TablePer::kVertex;
  }
  return table;
}

/// `standard_key` and `region_key` name what holds a value; `to_value` makes it.
template <typename Value, typename ToValue>
Field<Value> to_field(const CheckedValue& mapping, std::string_view standard_key, std::string_view region_key,
                      const ToValue& to_value) {
  const CheckedValue* standard = mapping.find(standard_key);
  if (standard == nullptr) return {.location = mapping.location, .table = to_table(mapping)};
  Field<Value> field{.location = standard->location};
  if (standard->find("file") != nullptr || standard->find("attribute") != nullptr) {
    field.table = to_table(*standard);
  } else {
    field.standard = to_value(*standard);
  }
  for (const CheckedValue& part : mapping.at("regions").items) {
    field.regions.push_back({.region = to_region(part.at("in")),
                             .value = to_value(part.at(region_key)),
                             .location = part.at("in").location});
  }
  return field;
}

Prestretch to_prestretch(const CheckedValue& value) {
  if (value.kind == CheckedKind::kNumber) return {.first = value.number, .second = value.number};
  const CheckedValue& values = value.at("values");
  return {.along = to_vector(value.at("along")), .first = values.items[0].number, .second = values.items[1].number};
}

}  // namespace

Region to_region(const CheckedValue& region) {
  const CheckedMember& part = region.members[0];
  const CheckedValue& value = part.value;
  if (part.key == "group") return GroupRegion{value.text};
  if (part.key == "plane") {
    return PlaneRegion{axis_index(value.at("axis")), value.at("at").number, value.at("within").number};
  }
  if (part.key == "below") return BelowRegion{axis_index(value.at("axis")), value.at("at").number};
  if (part.key == "above") return AboveRegion{axis_index(value.at("axis")), value.at("at").number};
  if (part.key == "box") return BoxRegion{to_vector(value.at("min")), to_vector(value.at("max"))};
  if (part.key == "sphere") return SphereRegion{to_vector(value.at("center")), value.at("radius").number};
  if (part.key == "all") return WholeRegion{};
  return BoundaryRegion{};
}

Field<double> to_number_field(const CheckedValue& value) {
  if (value.kind == CheckedKind::kNumber) return {.standard = value.number, .location = value.location};
  return to_field<double>(value, "default", "value", [](const CheckedValue& number) { return number.number; });
}

Field<Eigen::Vector3d> to_direction_field(const CheckedValue& fibres) {
  return to_field<Eigen::Vector3d>(fibres, "along", "along", to_vector);
}

Field<Prestretch> to_prestretch_field(const CheckedValue& value) {
  const bool is_alike_everywhere = value.kind == CheckedKind::kNumber || value.find("values") != nullptr;
  if (is_alike_everywhere) return {.standard = to_prestretch(value), .location = value.location};
  return to_field<Prestretch>(value, "default", "value", to_prestretch);
}

void read_material(const CheckedValue& material, BodyScenario& body) {
  body.material.law = find_wall_law(material.at("law").text);
  body.material_location = material.location;
  const WallLaw& law = *body.material.law;
  const auto add_parameters = [&](const CheckedValue& mapping, const std::string& path) {
    for (const LawParameter& parameter : law.parameters) {
      const Field<double> values = to_number_field(mapping.at(parameter.name));
      if (!is_uniform(values)) {
        const std::string own_path = member_path(path, std::string(parameter.name));
        body.parameter_fields.push_back({body.material.parameters.size(), own_path, values});
      }
      body.material.parameters.push_back(values.standard);
    }
  };
  if (law.terms.empty()) {
    add_parameters(material, "");
    return;
  }
  const CheckedValue& terms = material.at(law.terms);
  for (std::size_t index = 0; index < terms.items.size(); ++index) {
    add_parameters(terms.items[index], item_path(std::string(law.terms), index));
  }
}

}  // namespace thinwall
