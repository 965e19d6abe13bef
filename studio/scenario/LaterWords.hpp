#pragma once

#include <span>
#include <string_view>

namespace thinwall {

/// A key or word that belongs to the format but that this version cannot simulate or draw.
struct LaterWord {
  std::string_view where;  // the mapping's name for a key: "wall"; with the key for a word: "wall.model"
  std::string_view word;
  std::string_view words;  // how the message names it
};

/// The whole table.
std::span<const LaterWord> later_words();

/// The row of that place and word, or nullptr.
const LaterWord* find_later_word(std::string_view where, std::string_view word);

}  // namespace thinwall
