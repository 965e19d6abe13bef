#pragma once

#include <filesystem>

namespace thinwall {

/// Makes the folder and those above it when they are not there. Throws PictureFailure with reason and cure.
void make_folder(const std::filesystem::path& folder);

/// Throws PictureFailure with reason and cure.
void rename_folder(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes `folder` ready for a recording: makes it when it is not there, and removes what an earlier recording left
/// under the names of results, finished or not, so that no two recordings are mixed. Other files stay. Throws
/// PictureFailure, also when a folder of results (frames, surfaces) holds files that no recording writes.
void prepare_output_folder(const std::filesystem::path& folder);

}  // namespace thinwall
