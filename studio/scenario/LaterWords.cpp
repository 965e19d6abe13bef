#include "studio/scenario/LaterWords.hpp"

#include <algorithm>
#include <array>

namespace thinwall {
namespace {

constexpr std::array kLaterWords = {
    LaterWord{"camera", "follow", "`follow`"},
    LaterWord{"camera", "keyframes", "`keyframes`"},
};

}  // namespace

std::span<const LaterWord> later_words() {
  return kLaterWords;
}

const LaterWord* find_later_word(std::string_view where, std::string_view word) {
  const auto row = std::ranges::find_if(
      kLaterWords, [&](const LaterWord& later) { return later.where == where && later.word == word; });
  return row == kLaterWords.end() ? nullptr : &*row;
}

}  // namespace thinwall
