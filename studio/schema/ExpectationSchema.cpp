#include "studio/schema/ExpectationQuantity.hpp"
#include "studio/schema/SchemaSections.hpp"

namespace thinwall {
namespace {

ValueSchema bound_value(const std::string& example) {
  return {.kind = ValueKind::kAnyQuantity, .example = example};
}

}  // namespace

ValueSchema recorded_points_schema() {
  MappingSchema point{.name = "recorded point", .documentation = "A point of a wall whose motion is recorded."};
  point.keys = {
      {"body", name_value(), false, {}, "which body; may be left out when there is one only"},
      {"at",
       vector_value(kLength, {}, "[0, 0, 20 mm]"),
       true,
       {},
       "where it is on the stress-free surface: the vertex nearest to it is taken"},
  };
  return named_value(std::move(point));
}

ValueSchema expectations_schema() {
  ValueSchema bounds = list_value(bound_value("0.2 N"), 2);
  bounds.maximum_items = 2;
  bounds.example = "[0.2 N, 0.4 N]";
  const ValueSchema time = quantity_value(kTime, kFromZero, "1.5 s");
  MappingSchema expectation{
      .name = "expectation",
      .documentation =
          "What must come out. It has either `within`, or `value` and `tolerance`; each run checks it and "
          "ends with exit code 1 when it fails."};
  expectation.keys = {
      {"quantity", word_value(expectation_words()), true, {}, "what is measured, and what is made of it over time"},
      {"tool", name_value(), false, {}, "whose quantity it is; may be left out when there is one only"},
      {"body", name_value(), false, {}, "whose quantity it is; may be left out when there is one only"},
      {"chamber", name_value(), false, {}, "of the body: whose pressure, volume or fluid volume it is"},
      {"point", name_value(), false, {}, "the name in `record.points`; may be left out when there is one only"},
      {"at", time, false, {}, "the time of a quantity without prefix, between steps on the straight line between them"},
      {"from",
       time,
       false,
       {},
       "where the time that a `peak_`, `lowest_` or `mean_` is taken over begins; at 0 when absent"},
      {"until", time, false, {}, "where it ends; at the end of the run when absent"},
      {"within", bounds, false, {}, "smallest and largest allowed"},
      {"value", bound_value("0.3 N"), false, {}, "what is expected"},
      {"tolerance",
       bound_value("1 %"),
       false,
       {},
       "allowed difference from `value`: in its unit, or as a part of its magnitude without unit or in %"},
  };
  return list_value(mapping_value({expectation}));
}

}  // namespace thinwall
