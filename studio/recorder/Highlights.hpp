#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/overlay/ContactSheet.hpp"

namespace thinwall {

/// A frame as a video has it.
struct FinishedPicture {
  Image image;
  double time = 0;     // seconds, of the moment that it shows
  double force = 0;    // newton
  double covered = 0;  // by a card: 0 to 1
};

/// Picks from the frames of a recording, as they pass, the poster (the one with the largest force, the first of equals)
/// and pictures evenly spread for the contact sheet, without keeping all.
class Highlights {
 public:
  void add(const FinishedPicture& frame);

  const Image& poster() const { return poster_; }  // empty when there was no frame
  double poster_time() const { return poster_time_; }

  /// Up to twelve, shrunk and evenly spread, the first frame and about the last included; of frames in a row that show
  /// one moment the first of those that a card covers least, and none of a moment but the first that is seen under one
  /// alone.
  std::vector<SheetFrame> sheet_frames() const;

 private:
  Image poster_;
  double poster_time_ = 0;
  double largest_force_ = -1;
  std::optional<double> last_time_;
  double covered_ = 0;       // by a card, of the picture that shows that moment
  bool keeps_last_ = false;  // whether it is the last of `kept_`
  std::size_t frames_ = 0;   // those that show a moment of their own
  std::size_t stride_ = 1;   // every so many frames one is kept
  std::vector<SheetFrame> kept_;
};

}  // namespace thinwall
