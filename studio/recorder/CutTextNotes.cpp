#include "studio/recorder/CutTextNotes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace thinwall {
namespace {

/// Enough of a text to know it again, without half of a letter that takes several bytes.
std::string beginning_of(const std::string& text) {
  constexpr std::size_t kMost = 60;  // bytes
  constexpr unsigned kMark = 0xc0, kFollows = 0x80;
  if (text.size() <= kMost) return text;
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & kMark) == kFollows) --end;
  return text.substr(0, end) + "...";
}

}  // namespace

void CutTextNotes::see(const std::string& text) {
  if (std::ranges::find(texts_, text) == texts_.end()) texts_.push_back(text);
}

std::vector<std::string> CutTextNotes::notes(ImageSize size) const {
  std::vector<std::string> notes;
  for (const std::string& text : texts_) {
    notes.push_back(fmt::format(
        "in pictures of {} x {} there is no room for all of the text \"{}\": its end is cut off; shorten it, or "
        "tell it in two captions",
        size.width, size.height, beginning_of(text)));
  }
  return notes;
}

}  // namespace thinwall
