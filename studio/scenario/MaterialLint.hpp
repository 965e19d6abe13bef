#pragma once

#include <string>

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// Tells parameters of a law that do not go together, a law that lacks its fibres, and a tension field in a wall that
/// bends. `body`: a member of `bodies`; `path`: that of the body.
void check_material(const CheckedMember& body, const std::string& path, Diagnostics& diagnostics);

}  // namespace thinwall
