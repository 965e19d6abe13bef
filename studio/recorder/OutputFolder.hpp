#pragma once

#include <filesystem>

namespace thinwall {

/// In the folder of a recording: the records of the take that it is compared with.
inline constexpr const char* kSecondTakeFolder = "second_take";

/// Makes such a folder disappear. Throws PictureFailure, also when it holds what no recording writes.
void remove_second_take(const std::filesystem::path& folder);

/// Makes a folder of ground truth disappear. Throws PictureFailure, also when it holds what no recording writes.
void remove_ground_truth(const std::filesystem::path& folder);

/// Makes `folder` ready for a recording: makes it when it is not there, and removes what an earlier recording left
/// under the names of results, finished or not, so that no two recordings are mixed. Other files stay. Says
/// whether there were finished ones. Throws PictureFailure, also when a folder of results (frames, surfaces,
/// ground_truth, second_take) holds files that no recording writes.
bool prepare_output_folder(const std::filesystem::path& folder);

}  // namespace thinwall
