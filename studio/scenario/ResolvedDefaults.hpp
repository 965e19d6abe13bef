#pragma once

#include <string>

namespace thinwall {

/// A resolved scenario (JSON text) of any version with today's defaults where keys that have one are absent, as in
/// scenarios resolved before the format had those keys. Texts that are no JSON mapping come back as they are.
std::string with_defaults(const std::string& resolved);

}  // namespace thinwall
