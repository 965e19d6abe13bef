#pragma once

#include <string>

namespace thinwall {

/// The reference page of the scenario format in Markdown: rules, units, every mapping with its keys, values, defaults.
std::string scenario_reference();

}  // namespace thinwall
