#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace thinwall {

/// The user's text with its control characters spelled out, as a terminal would obey them.
std::string spelled_out(std::string_view text);

/// The user's text between backticks, on one line and cut to a readable length: control characters are spelled out.
std::string in_backticks(std::string_view text);

/// A path between backticks, whole, because its end is what tells: control characters are spelled out.
std::string path_in_backticks(std::string_view path);
/// What is wrong where a file ought to be and is none.
std::string no_file_words(const std::string& path);

/// Whether a text begins with a space that is none for YAML and quantities, as those that text processors set.
bool begins_with_foreign_space(std::string_view text);

/// As a shell takes it for one argument: in quotes where it has other than letters, digits and `_ - . / + = , : @`.
std::string shell_argument(std::string_view text);

/// "`a`, `b`, `c`"
std::string list_in_backticks(std::span<const std::string> words);

/// The word nearest to a mistyped one, or "" when none is near: at most a third of its letters changed, added, left out
/// or swapped with a neighbour.
std::string nearest_word(std::string_view mistyped, std::span<const std::string> words);

/// ", did you mean `word`?" or "".
std::string did_you_mean(std::string_view mistyped, std::span<const std::string> words);

/// Whether a text may name a body, a tool or a parameter: 1 to 64 letters, digits, `_` and `-`, a letter or `_` first.
bool is_name(std::string_view text);

/// What is wrong with a text that may not: its length where that is all, else what names are made of.
std::string name_mistake(std::string_view text);

}  // namespace thinwall
