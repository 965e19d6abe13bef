#pragma once

#include <string>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// A title or end card: words in the middle of a darkened picture.
struct Card {
  std::string title = {};
  std::string text = {};  // below the title, smaller; empty: none
  double opacity = 1;     // 0 to 1
  friend bool operator==(const Card&, const Card&) = default;
};

/// Darkens the picture and writes the card over it, in place of what was written over it before: as the card comes that
/// goes. Long texts wrap. `bare`: the picture with nothing written on it, of the same size.
void draw_card(Image& image, const Image& bare, const Card& card);

}  // namespace thinwall
