#pragma once

#include <string>
#include <utility>
#include <vector>

#include "studio/scenario/Diagnostics.hpp"
#include "studio/scenario/TextNode.hpp"

namespace thinwall {

/// Values from the command line: `--set name=value`.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Whether a parameter that nothing uses is an error: not in the second take of a comparison, where a change may stand
/// in the place of its last use.
enum class UnusedParameters { kRefused, kAllowed };

/// Puts the overrides into `parameters` and fills in each `${name}` of all values: a value that is `${name}` and
/// nothing else becomes the parameter's value, text or list; inside a longer text it becomes its text. Parameters may
/// use each other. An override that begins with `[` is read as a list. Errors: unknown names, cycles, a parameter that
/// nothing uses, an override without a parameter or given twice.
void parameter_pass(TextNode& root, const Overrides& overrides, Diagnostics& diagnostics,
                    UnusedParameters unused = UnusedParameters::kRefused);

}  // namespace thinwall
