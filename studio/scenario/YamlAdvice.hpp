#pragma once

#include <string>
#include <string_view>

namespace thinwall {

/// What people who write YAML by hand have most likely done where the parser gives up (line and column from 1, in
/// characters), and the cure: a sentence after `; `, or nothing where no guess is good.
std::string yaml_advice(const std::string& text, int line, int column, std::string_view parser_message);

/// Whether the quoted text that begins at `start` (`"` or `'`) has its second quotation mark.
bool is_quote_closed(std::string_view text, std::size_t start);

}  // namespace thinwall
