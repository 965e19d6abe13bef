#pragma once

#include <filesystem>
#include <optional>

#include "studio/golden/Attribution.hpp"
#include "studio/golden/GoldenVideoApproval.hpp"

namespace thinwall {

/// Of a video, judged.
struct VideoJudgement {
  GoldenResult result;
  std::optional<Attribution> attribution = {};  // when it failed
};

/// Compares today's video with what is approved in `folder`. Frames are equal by their hashes; of those that are not,
/// the ones that are kept as pictures have to be within the limits of the scenario, and of the others the mean colours
/// of each twelfth part within two levels or the allowed mean. The file that the encoder made has to hold each frame at
/// its time with the same tags, captions and chapters; where nothing before the encoder has changed, nor the encoder's
/// version, the same decoded pixels. A golden that has lost one of its files is missing. Throws GoldenError, also when
/// a picture that is kept is not that of its frame.
VideoJudgement compare_with_golden_video(const std::string& scenario, const GoldenDefinition& definition,
                                         const RecordedVideo& recorded, const std::filesystem::path& folder);

}  // namespace thinwall
