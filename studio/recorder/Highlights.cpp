#include "studio/recorder/Highlights.hpp"

#include <utility>

#include "renderer/image/Resize.hpp"

namespace thinwall {
namespace {

constexpr std::size_t kPictures = 12;
// Several times as many, so that after thinning out they still lie close to even spacing.
constexpr std::size_t kKept = 8 * kPictures;
constexpr int kWidth = 400;  // pixels, a cell of the contact sheet

Image shrunk(const Image& frame) {
  if (frame.size.width <= kWidth) return frame;
  return resize(frame, size_that_fits(frame.size, {.width = kWidth, .height = frame.size.height}));
}

}  // namespace

void Highlights::add(const FinishedPicture& frame) {
  if (frame.force > largest_force_) {
    largest_force_ = frame.force;
    poster_time_ = frame.time;
    poster_ = frame.image;
  }
  // Under cards and in freezes one moment is shown for long: it would fill half of the sheet of a short lesson.
  if (std::exchange(last_time_, frame.time) == frame.time) {
    if (frame.covered >= covered_) return;
    covered_ = frame.covered;
    if (keeps_last_) kept_.back().picture = shrunk(frame.image);
    return;
  }
  covered_ = frame.covered;
  // An end card comes over the last moment at once: a trace of its words would be seen.
  keeps_last_ = (kept_.empty() || !(frame.covered > 0)) && frames_++ % stride_ == 0;
  if (!keeps_last_) return;
  kept_.push_back({.picture = shrunk(frame.image), .time = frame.time});
  if (kept_.size() < kKept) return;
  std::vector<SheetFrame> thinned;
  for (std::size_t i = 0; i < kept_.size(); i += 2) thinned.push_back(std::move(kept_[i]));
  keeps_last_ = kept_.size() % 2 == 1;
  kept_ = std::move(thinned);
  stride_ *= 2;
}

std::vector<SheetFrame> Highlights::sheet_frames() const {
  if (kept_.size() <= kPictures) return kept_;
  std::vector<SheetFrame> chosen;
  for (std::size_t i = 0; i < kPictures; ++i) {
    chosen.push_back(kept_[(i * (kept_.size() - 1) + (kPictures - 1) / 2) / (kPictures - 1)]);
  }
  return chosen;
}

}  // namespace thinwall
