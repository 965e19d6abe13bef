#include "studio/schema/Wording.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace thinwall {
namespace {

constexpr std::size_t kLongestQuote = 60;     // bytes
constexpr std::size_t kLongestCompared = 64;  // bytes; nothing in the format is longer

char lower(char character) {
  return static_cast<char>(character >= 'A' && character <= 'Z' ? character - 'A' + 'a' : character);
}

/// Optimal string alignment distance, letters compared without case: Damerau 1964, Communications of the ACM 7(3).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) cost[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) cost[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool equal = lower(a[i - 1]) == lower(b[j - 1]);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + (equal ? 0 : 1)});
      if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1])) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[a.size()][b.size()];
}

std::string quoted(std::string_view text, std::size_t longest) {
  std::string out = "`";
  std::size_t end = text.size();
  if (end > longest) {
    end = longest;
    // A cut must not fall inside a character of several bytes.
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  }
  out += spelled_out(text.substr(0, end));
  return out + (end < text.size() ? "...`" : "`");
}

bool has_form_of_name(std::string_view text) {
  const auto is_letter = [](char character) {
    return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') || character == '_';
  };
  if (text.empty() || !is_letter(text.front())) return false;
  return std::ranges::all_of(text, [&](char character) {
    return is_letter(character) || (character >= '0' && character <= '9') || character == '-';
  });
}

}  // namespace

std::string spelled_out(std::string_view text) {
  std::string out;
  for (const char character : text) {
    if (character == '\n') {
      out += "\\n";
    } else if (static_cast<unsigned char>(character) < 0x20 || character == 0x7f) {
      std::array<char, 8> code;
      std::snprintf(code.data(), code.size(), "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(character)));
      out += code.data();
    } else {
      out += character;
    }
  }
  return out;
}

std::string in_backticks(std::string_view text) {
  return quoted(text, kLongestQuote);
}

std::string path_in_backticks(std::string_view path) {
  return quoted(path, path.size());
}

bool begins_with_foreign_space(std::string_view text) {
  // No-break spaces and the ideographic space; of the widths of typography, U+2000 to U+200A, the last bytes differ.
  constexpr std::array<std::string_view, 3> kSpaces = {"\u00A0", "\u202F", "\u3000"};
  constexpr std::string_view kFirstWidth = "\u2000", kLastWidth = "\u200A";
  const std::string_view first = text.substr(0, kFirstWidth.size());
  return (first >= kFirstWidth && first <= kLastWidth) ||
         std::ranges::any_of(kSpaces, [&](std::string_view space) { return text.starts_with(space); });
}

std::string no_file_words(const std::string& path) {
  std::error_code failure;
  if (std::filesystem::is_directory(path, failure)) {
    return path_in_backticks(path) + " is a folder; name a file in it";
  }
  const std::string cure = path.find('\\') == std::string::npos ? "" : "; `/` stands between folders, not `\\`";
  return "there is no file " + path_in_backticks(path) + cure;
}

std::string shell_argument(std::string_view text) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+=,:@";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos) return std::string(text);
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::string list_in_backticks(std::span<const std::string> words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + in_backticks(word);
  return out;
}

std::string nearest_word(std::string_view mistyped, std::span<const std::string> words) {
  if (mistyped.size() > kLongestCompared) return "";
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, mistyped.size() / 3) + 1;
  for (const std::string& word : words) {
    if (word.size() > kLongestCompared) continue;
    const std::size_t steps = distance(mistyped, word);
    if (steps < best_distance && steps < word.size()) {
      best = word;
      best_distance = steps;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view mistyped, std::span<const std::string> words) {
  const std::string word = nearest_word(mistyped, words);
  return word.empty() ? "" : ", did you mean " + in_backticks(word) + "?";
}

bool is_name(std::string_view text) {
  return text.size() <= kLongestCompared && has_form_of_name(text);
}

std::string name_mistake(std::string_view text) {
  if (!has_form_of_name(text)) return "a name has letters, digits, `_` and `-` and begins with a letter";
  return "a name has at most " + std::to_string(kLongestCompared) + " characters, this one has " +
         std::to_string(text.size());
}

}  // namespace thinwall
