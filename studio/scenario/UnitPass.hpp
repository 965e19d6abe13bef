#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"
#include "studio/scenario/TextNode.hpp"
#include "studio/schema/Schema.hpp"

namespace thinwall {

/// Reads the texts of a mapping against its schema: quantities become SI numbers, directions unit vectors, paths count
/// from the file that names them, defaults are filled in. Errors: unknown and missing keys, wrong kinds, units and
/// words, values out of range, what the format has but this version cannot do. What is wrong is left out of the result.
CheckedValue unit_pass(const TextNode& root, const MappingSchema& schema, Diagnostics& diagnostics);

}  // namespace thinwall
