#include "studio/scenario/YamlComments.hpp"

#include <algorithm>
#include <vector>

namespace thinwall {
namespace {

bool is_space(char character) {
  return character == ' ' || character == '\t' || character == '\n' || character == '\r';
}

/// The first byte from `at` on that is no space; the text's size when there is none.
std::size_t after_spaces(std::string_view text, std::size_t at) {
  while (at < text.size() && is_space(text[at])) ++at;
  return at;
}

std::string_view rest_of_line(std::string_view text, std::size_t at) {
  return text.substr(at, text.find_first_of("\r\n", at) - at);
}

/// Whether what YAML takes for a comment was most likely meant as text: one that is meant begins with `# `.
bool is_like_text(std::string_view comment) {
  return comment.size() > 1 && comment[0] == '#' && !is_space(comment[1]);
}

/// Goes through a text as far as brackets, quotation marks and comments are concerned.
class BracketScan {
 public:
  BracketScan(std::string_view source, std::size_t end) : source_(source), end_(std::min(end, source.size())) {}

  std::optional<OpenBracket> innermost() {
    for (std::size_t at = 0; at < end_;) at = take(at);
    return open_.empty() ? std::nullopt : std::optional(open_.back());
  }

 private:
  /// The byte to go on with.
  std::size_t take(std::size_t at) {
    const char byte = source_[at];
    if (byte == '\n') return begin_line(at);
    if (byte == '#' && (at == 0 || is_space(source_[at - 1]))) return pass_comment(at);
    if (is_space(byte)) return at + 1;
    const bool begins_value = begins_value_;
    begins_value_ = byte == ':' || byte == ',' || byte == '-';
    if ((byte == '"' || byte == '\'') && begins_value) return behind_quotes(at);
    if ((byte == '{' || byte == '[') && (begins_value || !open_.empty())) {
      open_.push_back({.bracket = byte, .line = line_});
      begins_value_ = true;
    } else if ((byte == '}' || byte == ']') && !open_.empty()) {
      open_.pop_back();
    }
    return at + 1;
  }

  std::size_t begin_line(std::size_t at) {
    ++line_;
    begins_value_ = true;
    return at + 1;
  }

  std::size_t pass_comment(std::size_t at) {
    const std::string_view comment = rest_of_line(source_, at);
    const bool hides_an_end = is_like_text(comment) && comment.find_first_of("}]") != std::string_view::npos;
    if (!open_.empty() && hides_an_end) open_.back().hidden = comment;
    return at + comment.size();
  }

  std::size_t behind_quotes(std::size_t at) {
    const char quote = source_[at];
    for (++at; at < end_; ++at) {
      if (source_[at] == '\n') ++line_;
      const bool is_doubled = quote == '\'' && source_.substr(at).starts_with("''");
      if (is_doubled || (source_[at] == '\\' && quote == '"')) {
        ++at;
        if (at < end_ && source_[at] == '\n') ++line_;
      } else if (source_[at] == quote) {
        break;
      }
    }
    return at + 1;
  }

  std::string_view source_;
  std::size_t end_;
  std::vector<OpenBracket> open_;
  int line_ = 1;
  bool begins_value_ = true;
};

}  // namespace

std::string comment_like_text(std::string_view source, std::size_t start, std::string_view plain) {
  std::size_t at = start;
  if (at < source.size() && source[at] == '&') at = source.find_first_of(" \t\r\n", at);
  // Line ends within the text have become spaces, so only what is no space is compared.
  for (const char byte : plain) {
    if (is_space(byte)) continue;
    at = after_spaces(source, at);
    if (at >= source.size() || source[at] != byte) return "";
    ++at;
  }
  const std::string_view behind = rest_of_line(source, std::min(at, source.size()));
  const bool is_hidden = !behind.empty() && is_space(behind[0]) && is_like_text(behind.substr(1));
  return std::string(is_hidden ? behind.substr(1) : "");
}

std::optional<OpenBracket> open_bracket(std::string_view source, std::size_t end) {
  return BracketScan(source, end).innermost();
}

}  // namespace thinwall
