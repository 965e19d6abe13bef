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

/// Darkens the picture and writes the card over it. Long texts wrap.
void draw_card(Image& image, const Card& card);

}  // namespace thinwall
