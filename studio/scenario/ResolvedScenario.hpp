#pragma once

#include <filesystem>
#include <string>

#include "studio/scenario/CheckedValue.hpp"

namespace thinwall {

/// The checked scenario as JSON text: keys in the order of the schema, parameters and defaults filled in, numbers in SI
/// units (metre, kilogram, second, radian), paths from `folder`. Equal scenarios give equal texts wherever they lie.
std::string resolved_scenario(const CheckedValue& root, const std::filesystem::path& folder);

}  // namespace thinwall
