#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "studio/record/TimedText.hpp"
#include "studio/recorder/VideoClock.hpp"

namespace thinwall {

/// Captions in the time of the video: each holds as the frames show it, after a freeze at its begin and with one at its
/// end. Before the caption of the first moment there is none, so that it holds from where a title card of `title`
/// seconds ends, also in a freeze.
std::vector<TimedText> shown_captions(std::vector<TimedText> captions, const VideoClock& clock, double title = 0);

/// Chapters in the time of a video that lasts until `end`: a freeze, and with it a title card, belongs to the chapter
/// that begins there, and each lasts until the next one, as clips without a chapter belong to that before them.
std::vector<TimedText> shown_chapters(std::vector<TimedText> chapters, const VideoClock& clock, double end);

/// The texts cut off at the end of what was recorded.
template <typename Text, typename Member>
std::vector<Text> up_to(double end, const std::vector<TimedText>& texts, Member Text::*text) {
  std::vector<Text> result;
  for (const TimedText& timed : texts) {
    if (timed.begin >= end) continue;
    Text copy;
    copy.begin = timed.begin;
    copy.end = std::min(timed.end, end);
    copy.*text = timed.text;
    result.push_back(std::move(copy));
  }
  return result;
}

}  // namespace thinwall
