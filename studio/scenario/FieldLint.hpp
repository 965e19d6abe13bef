#pragma once

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// What is wrong with the sources of a wall's fields: tables that are not there, properties of surfaces that have none,
/// a prestretch with neither one nor five columns.
void check_fields(const CheckedMember& body, const std::string& path, Diagnostics& diagnostics);

}  // namespace thinwall
