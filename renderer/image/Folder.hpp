#pragma once

#include <filesystem>

namespace thinwall {

/// Makes the folder and those above it when they are not there. Throws PictureFailure with reason and cure.
void make_folder(const std::filesystem::path& folder);

/// Throws PictureFailure with reason and cure.
void rename_folder(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace thinwall
