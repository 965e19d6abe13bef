#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// Each takes a checked value that the schema's table of the same kind let through.
Region to_region(const CheckedValue& region);
Field<double> to_number_field(const CheckedValue& value);
Field<Eigen::Vector3d> to_direction_field(const CheckedValue& fibres);
Field<Prestretch> to_prestretch_field(const CheckedValue& value);

/// Fills in the law, its parameters and which of them are fields.
void read_material(const CheckedValue& material, BodyScenario& body);

}  // namespace thinwall
