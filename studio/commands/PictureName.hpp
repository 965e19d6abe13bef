#pragma once

#include <filesystem>
#include <string>

namespace thinwall {

/// Throws UsageError, with the cure, where what `option` names is no name of a picture file to be made: pictures are
/// written as PNG, whatever their names say.
void require_picture_name(const std::string& option, const std::filesystem::path& name);

}  // namespace thinwall
