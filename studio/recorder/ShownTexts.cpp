#include "studio/recorder/ShownTexts.hpp"

#include "renderer/snapshot/SameTime.hpp"

namespace thinwall {

std::vector<TimedText> shown_captions(std::vector<TimedText> captions, const VideoClock& clock, double title) {
  for (TimedText& caption : captions) {
    caption.begin = caption.begin < kSameTime ? title : clock.last_shown(caption.begin);
    caption.end = clock.last_shown(caption.end);
  }
  return captions;
}

std::vector<TimedText> shown_chapters(std::vector<TimedText> chapters, const VideoClock& clock) {
  for (TimedText& chapter : chapters) {
    chapter.begin = clock.first_shown(chapter.begin);
    chapter.end = clock.first_shown(chapter.end);
  }
  return chapters;
}

}  // namespace thinwall
