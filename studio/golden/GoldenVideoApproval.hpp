#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studio/golden/GoldenApproval.hpp"
#include "studio/golden/GoldenVideo.hpp"

namespace thinwall {

/// The approved video of a scenario.
struct GoldenVideoApproval {
  GoldenVideo video;
  std::vector<std::string> pictures;  // (video.kept): file names in the scenario's golden folder
  std::string who;
  std::string why;
  std::string history = {};             // file name in that folder
  std::vector<std::string> files = {};  // all of it in that folder, by their names
};

/// Of that driver; else of the first other one, in order of the files' names; none when no video is approved. Throws
/// GoldenError.
std::optional<GoldenVideoApproval> find_video_approval(const std::filesystem::path& folder, const std::string& driver);

/// Of all drivers. Throws GoldenError.
std::vector<GoldenVideoApproval> read_video_approvals(const std::filesystem::path& folder);

/// Makes today's video the golden of its driver: pictures, history and last the file that names them; pictures that the
/// earlier one kept and this one does not are removed. Throws PictureFailure, GoldenError.
void renew_golden_video(const RecordedVideo& recorded, const std::filesystem::path& folder, const std::string& who,
                        const std::string& why);

}  // namespace thinwall
