#pragma once

#include <string>

namespace thinwall {

/// The scenario format as JSON Schema (draft 7) for editors: keys, words, kinds of values, defaults and documentation.
/// A file that includes others may leave out what is needed. Units, ranges of quantities and names are the reader's to
/// check.
std::string scenario_json_schema();

}  // namespace thinwall
