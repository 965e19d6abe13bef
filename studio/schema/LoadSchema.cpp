#include "studio/schema/SchemaSections.hpp"

namespace thinwall {
namespace {

MappingSchema load(const std::string& kind, ValueSchema value, const std::string& documentation) {
  MappingSchema mapping{.name = "load", .documentation = "A load on a part of the wall."};
  const ValueSchema moment = tuple_value({quantity_value(kTime, kFromZero, "1 s"), quantity_value(kDimensionless)});
  mapping.keys = {
      {kind, std::move(value), true, {}, documentation},
      {"region", region_schema(), true, {}, "where it acts"},
      {"over",
       list_value(moment, 1),
       false,
       {},
       "times and the part of the load at each, straight between them and even beyond; all of it from before time zero "
       "when absent"},
  };
  return mapping;
}

}  // namespace

ValueSchema loads_schema() {
  return list_value(mapping_value({
      load("pressure", quantity_value(kPressure, kFluidPressures, "2 kPa"),
           "pressure along the wall's outer normal; follows the wall as it moves"),
      load("force", vector_value(kForce, {}, "[0, 0, -1 N]"), "force in all, spread evenly; keeps its direction"),
      load("line_force", vector_value(kForcePerLength, {}, "[0, 0, 60 N/m]"),
           "force per length of the edges within the region, the open ones where it has any; keeps its direction"),
      load("moment", vector_value(kEnergy, {}, "[0, 3 mJ, 0]"),
           "moment in all, about an axis that keeps its direction; turns the wall beside the edges within the region"),
      load("traction", vector_value(kPressure, {}, "[0, 0, 2 kPa]"),
           "force per area of the stress-free wall; keeps its direction"),
      load("body_force", vector_value(kForcePerVolume, {}, "[0, 0, -10 kN/m^3]"),
           "force per volume of the stress-free wall; keeps its direction"),
  }));
}

}  // namespace thinwall
