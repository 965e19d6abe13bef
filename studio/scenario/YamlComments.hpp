#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace thinwall {

/// What stands behind a plain text and was most likely meant to belong to it: the `#1` of `title: Balloon #1`, which
/// YAML takes for a comment. `start`: the byte of `source` at which the text, or its anchor, begins; `plain`: the text
/// as the parser gives it. Empty where nothing stands there, where ` # ` or more than one space begins a comment.
std::string comment_like_text(std::string_view source, std::size_t start, std::string_view plain);

/// A `{` or `[` that has no end yet.
struct OpenBracket {
  char bracket = '{';
  int line = 1;             // counted from 1
  std::string hidden = "";  // the comment within it that looks like text and holds a `}` or `]`; or none
};

/// The innermost bracket that is open before the byte `end` of a YAML text; empty where none is.
std::optional<OpenBracket> open_bracket(std::string_view source, std::size_t end);

}  // namespace thinwall
