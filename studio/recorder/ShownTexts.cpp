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

std::vector<TimedText> shown_chapters(std::vector<TimedText> chapters, const VideoClock& clock, double end) {
  for (TimedText& chapter : chapters) chapter.begin = clock.first_shown(chapter.begin);
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    chapters[i].end = i + 1 < chapters.size() ? chapters[i + 1].begin : end;
  }
  return chapters;
}

}  // namespace thinwall
