#pragma once

#include "studio/schema/Schema.hpp"

namespace thinwall {

/// The sections of a scenario: the values of its keys of these names. The table is the contents of these functions.
ValueSchema bodies_schema();
ValueSchema loads_schema();
ValueSchema tools_schema();
ValueSchema timeline_schema();
ValueSchema simulation_schema();
ValueSchema camera_schema();
ValueSchema cameras_schema();
ValueSchema cuts_schema();
ValueSchema comparison_schema();
ValueSchema lights_schema();
ValueSchema look_schema();
ValueSchema teaching_schema();
ValueSchema record_schema();
ValueSchema golden_schema();
ValueSchema recorded_points_schema();
ValueSchema expectations_schema();

/// A part of the stress-free surface.
ValueSchema region_schema();
ValueSchema material_schema();
ValueSchema fibres_schema();

/// The prestretch of a wall: a number, one along and one across a direction, or a field of these.
ValueSchema prestretch_schema();

/// A number that may be given as a field over the wall besides: by regions, from a table, from the mesh file.
ValueSchema field_schema(ValueSchema number);

/// Shorthands for the values of the table.
inline constexpr Range kAboveZero{.minimum = 0, .minimum_excluded = true};
/// Pressures of fluids, pascal: beyond what any wall holds.
inline constexpr Range kFluidPressures{.minimum = -1e9, .maximum = 1e9};
inline constexpr Range kFromZero{.minimum = 0};
inline constexpr Range kFromZeroToOne{.minimum = 0, .maximum = 1};

ValueSchema text_value();
ValueSchema path_value();
ValueSchema name_value();
ValueSchema boolean_value();
ValueSchema word_value(std::vector<std::string> words);
ValueSchema integer_value(int minimum, int maximum, const std::string& example);
/// Without an example the one of the dimension.
ValueSchema quantity_value(const Dimension& dimension, const Range& range = {}, const std::string& example = "");
ValueSchema direction_value();
/// Three components.
ValueSchema vector_value(const Dimension& dimension, const Range& range, const std::string& example);
ValueSchema list_value(ValueSchema item, std::size_t minimum_items = 0);
/// A list with a value of its own for each place.
ValueSchema tuple_value(std::vector<ValueSchema> items);
ValueSchema mapping_value(std::vector<MappingSchema> alternatives);
/// A quantity, or a list of them, that is told of beyond what is usual.
ValueSchema usually(ValueSchema value, const UsualRange& usual);
ValueSchema named_value(MappingSchema mapping, std::size_t minimum_items = 0);

}  // namespace thinwall
