#include "studio/scenario/YamlAdvice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <vector>

#include "studio/scenario/YamlComments.hpp"

namespace thinwall {
namespace {

/// The lines up to and with `last`.
std::vector<std::string> first_lines(const std::string& text, int last) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; static_cast<int>(lines.size()) < last && std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

std::size_t indentation(std::string_view line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

bool is_blank(std::string_view line) {
  const std::size_t start = indentation(line);
  return start == line.size() || line[start] == '#';
}

/// Where a line has the colon that ends a key, in bytes; npos: nowhere.
std::size_t key_colon(std::string_view line) {
  const std::size_t inside = line.find(": ");
  if (inside != std::string_view::npos) return inside;
  return line.ends_with(':') ? line.size() - 1 : std::string_view::npos;
}

/// The line before the last one that says something, counted from 1; 0: none.
std::size_t line_before(const std::vector<std::string>& lines) {
  for (std::size_t number = lines.size() - 1; number > 0; --number) {
    if (!is_blank(lines[number - 1])) return number;
  }
  return 0;
}

/// What stands in a line from a column on, which is counted from 1 in characters.
std::string_view from_column(std::string_view line, int column) {
  const auto is_first_byte = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; };
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (is_first_byte(line[at]) && --column == 0) return line.substr(at);
  }
  return "";
}

/// The byte at which a line begins; counted from 1.
std::size_t start_of_line(const std::string& text, int line) {
  std::size_t start = 0;
  for (int before = 1; before < line && start != std::string::npos; ++before) start = text.find('\n', start) + 1;
  return start;
}

/// Of a bracket that the parser waits for the end of, which may lie many lines before the place where it gives up.
std::string advice_for_an_open_bracket(const OpenBracket& open, int line) {
  const std::string place = fmt::format("; `{}` of line {} is still open here", open.bracket, open.line);
  if (!open.hidden.empty()) {
    constexpr const char* kWords =
        "{}, as `{}` is taken for a comment: a text with ` #` in it needs quotation marks around it";
    return fmt::format(kWords, place, open.hidden);
  }
  const std::string missing = fmt::format("{}a `,` or `{}` is missing before this",
                                          open.line < line ? place + ": " : "; ", open.bracket == '{' ? '}' : ']');
  if (open.bracket == '[') return missing;
  return missing + ", or a text with `{`, `}`, `,` or `${` in it has no quotation marks around it";
}

std::string advice_for_an_alias(std::string_view alias) {
  const std::string_view name = alias.substr(0, alias.find_first_of(" ,]}")).substr(1);
  constexpr const char* kWords =
      "; `*{0}` stands for what `&{0}` marks before it; a text that begins with `*` needs quotation marks around it";
  return fmt::format(kWords, name);
}

std::string advice_for_a_colon(const std::vector<std::string>& lines, int column) {
  const std::string& line = lines.back();
  const std::size_t colon = key_colon(line);
  if (colon != std::string::npos && colon + 1 < static_cast<std::size_t>(column)) {
    return "; a text with `: ` in it needs quotation marks around it";
  }
  const std::size_t before = line_before(lines);
  if (before == 0) return "";
  const std::string& previous = lines[before - 1];
  if (key_colon(previous) == std::string::npos) {
    return fmt::format("; in line {} a key is to be followed by `:` and a space", before);
  }
  return fmt::format("; it is indented by {} spaces, and line {} by {}: keys of one mapping begin in the same column",
                     indentation(line), before, indentation(previous));
}

std::string advice_for_indentation(const std::vector<std::string>& lines) {
  const std::size_t dash = lines.back().find("- ");
  if (dash != std::string::npos && dash == indentation(lines.back())) {
    return "; items of one list begin with `- ` in the same column, keys of one mapping in the same column without it";
  }
  return "; keys of one mapping begin in the same column, and each item of a list begins with `- `";
}

}  // namespace

std::string yaml_advice(const std::string& text, int line, int column, std::string_view parser_message) {
  const std::vector<std::string> lines = first_lines(text, line);
  if (lines.empty()) return "";
  const std::string_view rest = from_column(lines.back(), column);
  const std::optional<OpenBracket> open =
      open_bracket(text, start_of_line(text, line) + (lines.back().size() - rest.size()));
  const bool waits_for_an_end = parser_message == "end of map flow not found" ||
                                parser_message == "illegal block entry" ||
                                parser_message == "end of sequence flow not found";
  if (open && (waits_for_an_end || !open->hidden.empty())) return advice_for_an_open_bracket(*open, line);
  if (parser_message == "illegal map value") return advice_for_a_colon(lines, column);
  if (parser_message == "the referenced anchor is not defined" && rest.starts_with('*')) {
    return advice_for_an_alias(rest);
  }
  if (parser_message == "unknown token" && !rest.empty()) {
    return fmt::format("; a text that begins with `{}` needs quotation marks around it", rest[0]);
  }
  if (parser_message == "illegal flow end" && !rest.empty()) {
    return fmt::format("; `{}` closes nothing that is open here: `{{` goes with `}}`, `[` with `]`", rest[0]);
  }
  if (parser_message == "end of map not found" || parser_message == "end of sequence not found") {
    return advice_for_indentation(lines);
  }
  return "";
}

bool is_quote_closed(std::string_view text, std::size_t start) {
  const char quote = text[start];
  for (std::size_t at = start + 1; at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text[at] == quote) {
      if (quote == '"' || at + 1 == text.size() || text[at + 1] != quote) return true;
      ++at;
    }
  }
  return false;
}

}  // namespace thinwall
