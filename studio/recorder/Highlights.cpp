#include "studio/recorder/Highlights.hpp"

#include "renderer/image/Resize.hpp"

namespace thinwall {
namespace {

constexpr std::size_t kPictures = 12;
// Several times as many, so that after thinning out they still lie close to even spacing.
constexpr std::size_t kKept = 4 * kPictures;
constexpr ImageSize kThumbnailBox = {.width = 320, .height = 240};

}  // namespace

void Highlights::add(const Image& frame, double time, double force) {
  if (force > largest_force_) {
    largest_force_ = force;
    poster_time_ = time;
    poster_ = frame;
  }
  if (frames_++ % stride_ != 0) return;
  kept_.push_back({.time = time, .image = resize(frame, size_that_fits(frame.size, kThumbnailBox))});
  if (kept_.size() < kKept) return;
  std::vector<Thumbnail> thinned;
  for (std::size_t i = 0; i < kept_.size(); i += 2) thinned.push_back(std::move(kept_[i]));
  kept_ = std::move(thinned);
  stride_ *= 2;
}

std::vector<Thumbnail> Highlights::thumbnails() const {
  if (kept_.size() <= kPictures) return kept_;
  std::vector<Thumbnail> chosen;
  for (std::size_t i = 0; i < kPictures; ++i) {
    chosen.push_back(kept_[(i * (kept_.size() - 1) + (kPictures - 1) / 2) / (kPictures - 1)]);
  }
  return chosen;
}

}  // namespace thinwall
