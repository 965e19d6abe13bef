#pragma once

#include <string>
#include <vector>

#include "studio/golden/Attribution.hpp"
#include "studio/golden/GoldenVideo.hpp"

namespace thinwall {

/// Everything that is found of a video that is not the golden one, kept apart by where it comes from.
struct VideoFindings {
  std::vector<std::string> frames;   // beyond the limits, before the encoder
  std::vector<std::string> texts;    // captions, before the encoder
  std::vector<std::string> encoder;  // of the file

  std::vector<std::string> before_encoder() const {
    std::vector<std::string> both = frames;
    both.insert(both.end(), texts.begin(), texts.end());
    return both;
  }
  std::vector<std::string> all() const {
    std::vector<std::string> whole = before_encoder();
    whole.insert(whole.end(), encoder.begin(), encoder.end());
    return whole;
  }
};

/// Whether both end in the same state to the last bit, and the takes that they are compared with.
bool have_same_last_state(const GoldenVideo& golden, const GoldenVideo& today);

/// Why today's video is not the golden one, where something is found. Throws GoldenError when a history is none.
Attribution attribute_video(const GoldenVideo& golden, const GoldenVideo& today, const VideoFindings& found);

/// With semicolons between.
std::string one_after_the_other(const std::vector<std::string>& sentences);

}  // namespace thinwall
