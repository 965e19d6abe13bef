#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <utility>

namespace thinwall {

/// Says something to people who read along, on standard error or another stream. What the stream does not take is
/// lost: messages are no results, so that a full disk there fails no command.
template <typename... Values>
void print_message(std::FILE* stream, fmt::format_string<Values...> words, Values&&... values) {
  std::fputs(fmt::format(words, std::forward<Values>(values)...).c_str(), stream);
}

}  // namespace thinwall
