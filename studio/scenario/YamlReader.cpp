#include "studio/scenario/YamlReader.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>

#include "studio/scenario/YamlAdvice.hpp"
#include "studio/scenario/YamlComments.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

constexpr std::uintmax_t kLargestFile = 1 << 20;  // bytes
constexpr std::size_t kDeepest = 64;              // levels
constexpr std::size_t kMostNodes = 100000;

/// Ends the reading of a file at a place.
struct Refusal {
  int line = 1;
  int column = 1;
  std::string message;
};

/// yaml-cpp counts bytes from 0; people count characters from 1.
class Places {
 public:
  explicit Places(const std::string& text) {
    line_starts_.push_back(0);
    for (std::size_t at = 0; at < text.size(); ++at) {
      if (text[at] == '\n') line_starts_.push_back(at + 1);
    }
    text_ = &text;
  }

  SourceLocation at(const YAML::Mark& mark, const std::filesystem::path& file) {
    const auto last_line = static_cast<int>(line_starts_.size());
    if (mark.line < 0 || mark.line >= last_line) return {file, last_line, 1};
    const std::size_t start = line_starts_[static_cast<std::size_t>(mark.line)];
    const std::size_t end = std::min(text_->size(), start + static_cast<std::size_t>(std::max(0, mark.column)));
    // Counting goes on from the last place of the same line: a line of a megabyte is counted once.
    if (counted_from_ != start || counted_to_ > end) {
      counted_from_ = start;
      counted_to_ = start;
      column_ = 1;
    }
    for (; counted_to_ < end; ++counted_to_) {
      if ((static_cast<unsigned char>((*text_)[counted_to_]) & 0xC0) != 0x80) ++column_;
    }
    return {file, mark.line + 1, column_};
  }

  /// Whether a quoted text at `mark`, or behind the anchor that stands there, ends: the parser takes one that does not
  /// to the end of the file, with all that follows.
  bool is_quote_closed_at(const YAML::Mark& mark) const {
    const std::size_t quote = text_->find_first_of("\"'", byte_at(mark));
    return quote == std::string::npos || is_quote_closed(*text_, quote);
  }

  /// As `comment_like_text` tells of the plain text at `mark`.
  std::string cut_off_at(const YAML::Mark& mark, const std::string& plain) const {
    return comment_like_text(*text_, byte_at(mark), plain);
  }

 private:
  /// The text's size for a mark beyond it.
  std::size_t byte_at(const YAML::Mark& mark) const {
    if (mark.line < 0 || static_cast<std::size_t>(mark.line) >= line_starts_.size()) return text_->size();
    return line_starts_[static_cast<std::size_t>(mark.line)] + static_cast<std::size_t>(mark.column);
  }

  std::vector<std::size_t> line_starts_;  // byte offsets
  const std::string* text_;
  std::size_t counted_from_ = 0;  // byte offset of a line
  std::size_t counted_to_ = 0;    // byte offset in it whose column is `column_`
  int column_ = 1;
};

/// Builds nodes from the parser's events.
class NodeBuilder : public YAML::EventHandler {
 public:
  NodeBuilder(Places& places, const std::filesystem::path& file, Diagnostics& diagnostics)
      : places_(places), file_(file), diagnostics_(diagnostics) {}

  TextNode root;

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    take(TextNode{.location = places_.at(mark, file_), .members = {}}, anchor);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_tag(mark, tag);
    if (tag == "!" && !places_.is_quote_closed_at(mark)) {
      refuse(mark,
             "the quotation mark that begins here has no second one, so that all that follows is part of the text");
    }
    TextNode node{.kind = NodeKind::kText, .location = places_.at(mark, file_), .text = value, .members = {}};
    if (tag == "?") node.cut_off = places_.cut_off_at(mark, value);
    take(std::move(node), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto known = anchors_.find(anchor);
    if (known == anchors_.end()) refuse(mark, "an alias inside the value that it stands for");
    count(mark, count_nodes(known->second));
    // The copy keeps the places of the anchored text: that is where a wrong value is put right.
    add(known->second);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, NodeKind::kList);
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, NodeKind::kMapping);
  }
  void OnMapEnd() override { close(); }

 private:
  /// A list or mapping whose end has not come yet.
  struct Level {
    TextNode node;
    YAML::anchor_t anchor;
    bool has_key = false;
    bool keep = true;  // false for the value of a key that was refused
    TextMember member;
    std::map<std::string, int> lines_of_keys;
  };

  [[noreturn]] void refuse(const YAML::Mark& mark, const std::string& message) {
    const SourceLocation place = places_.at(mark, file_);
    throw Refusal{place.line, place.column, message};
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
    // "?" and "!" are the parser's words for plain and quoted text without a tag.
    if (!tag.empty() && tag != "?" && tag != "!")
      refuse(mark, "YAML tags such as " + in_backticks(tag) + " are not allowed; leave it out");
  }

  void count(const YAML::Mark& mark, std::size_t nodes) {
    nodes_ += nodes;
    if (nodes_ > kMostNodes) refuse(mark, "more than 100000 values, aliases counted in full");
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, NodeKind kind) {
    refuse_tag(mark, tag);
    if (levels_.size() >= kDeepest) refuse(mark, "nested more than 64 levels deep");
    count(mark, 1);
    Level level;
    level.node.kind = kind;
    level.node.location = places_.at(mark, file_);
    level.anchor = anchor;
    levels_.push_back(std::move(level));
  }

  void close() {
    Level level = std::move(levels_.back());
    levels_.pop_back();
    if (level.anchor != 0) anchors_[level.anchor] = level.node;
    add(std::move(level.node));
  }

  void take(TextNode node, YAML::anchor_t anchor) {
    if (++nodes_ > kMostNodes) {
      throw Refusal{node.location.line, node.location.column, "more than 100000 values, aliases counted in full"};
    }
    if (anchor != 0) anchors_[anchor] = node;
    add(std::move(node));
  }

  void add(TextNode node) {
    if (levels_.empty()) {
      root = std::move(node);
      return;
    }
    Level& level = levels_.back();
    if (level.node.kind == NodeKind::kList) {
      level.node.items.push_back(std::move(node));
    } else if (!level.has_key) {
      add_key(level, node);
    } else {
      level.member.value = std::move(node);
      if (level.keep) level.node.members.push_back(std::move(level.member));
      level.has_key = false;
    }
  }

  /// The path of the innermost list or mapping.
  std::string path() const {
    std::string path;
    for (std::size_t depth = 0; depth + 1 < levels_.size(); ++depth) {
      const Level& level = levels_[depth];
      path = level.node.kind == NodeKind::kList ? item_path(path, level.node.items.size())
                                                : member_path(path, level.member.key);
    }
    return path;
  }

  void add_key(Level& level, const TextNode& node) {
    level.has_key = true;
    level.keep = false;
    level.member = TextMember{node.text, node.location, {}};
    if (node.kind != NodeKind::kText) {
      diagnostics_.error(node.location, path(), "a key must be a text, not " + describe(node));
      return;
    }
    if (begins_with_foreign_space(node.text)) {
      diagnostics_.error(
          node.location, path(),
          "this line is indented with a space that is none for YAML, as text processors set them; indent "
          "it with plain spaces");
      return;
    }
    if (node.text == "<<") {
      diagnostics_.error(node.location, path(),
                         "`<<` does not merge here; put what is shared in a file and `include` it");
      return;
    }
    const auto [first, is_new] = level.lines_of_keys.emplace(node.text, node.location.line);
    if (!is_new) {
      diagnostics_.error(
          node.location, member_path(path(), node.text),
          "duplicate key, first given in line " + std::to_string(first->second) + "; leave one of both out");
      return;
    }
    level.keep = true;
  }

  Places& places_;
  const std::filesystem::path& file_;
  Diagnostics& diagnostics_;
  std::vector<Level> levels_;
  std::map<YAML::anchor_t, TextNode> anchors_;
  std::size_t nodes_ = 0;
};

/// The length of the UTF-8 character at `at`, or 0 when there is none: Unicode 15.0, table 3-7.
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t offset) -> unsigned {
    return at + offset < text.size() ? static_cast<unsigned char>(text[at + offset]) : 0U;
  };
  const auto continues = [&](std::size_t offset) { return (byte(offset) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return continues(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool allowed = (first != 0xE0 || byte(1) >= 0xA0) && (first != 0xED || byte(1) <= 0x9F);
    return allowed && continues(1) && continues(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool allowed = (first != 0xF0 || byte(1) >= 0x90) && (first != 0xF4 || byte(1) <= 0x8F);
    return allowed && continues(1) && continues(2) && continues(3) ? 4 : 0;
  }
  return 0;
}

void refuse_what_is_no_text(std::string_view text) {
  int line = 1;
  int column = 1;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    if (length == 0) throw Refusal{line, column, "not a text file: this byte is no UTF-8; save the file in UTF-8"};
    const auto byte = static_cast<unsigned char>(text[at]);
    if ((byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7f) {
      throw Refusal{line, column, "not a text file: a control character stands here"};
    }
    ++column;
    if (byte == '\n') {
      ++line;
      column = 1;
    }
    at += length;
  }
}

/// The first line up to `last` whose indentation has a tab in it, which YAML does not allow; 0: none.
int tabbed_line(const std::string& text, int last) {
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; number <= last && std::getline(stream, line); ++number) {
    const std::size_t end = line.find_first_not_of(" \t");
    if (line.substr(0, end).find('\t') != std::string::npos) return number;
  }
  return 0;
}

TextNode parse(const std::string& text, const std::filesystem::path& file, Diagnostics& diagnostics) {
  refuse_what_is_no_text(text);
  Places places(text);
  std::istringstream stream(text);
  NodeBuilder builder(places, file, diagnostics);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) return TextNode{.location = {file, 1, 1}, .members = {}};
    NodeBuilder second(places, file, diagnostics);
    if (parser.HandleNextDocument(second)) {
      const SourceLocation& place = second.root.location;
      throw Refusal{place.line, place.column, "a second document begins here; a scenario is one document"};
    }
  } catch (const YAML::Exception& error) {
    const SourceLocation place = places.at(error.mark, file);
    if (const int tabbed = tabbed_line(text, place.line)) {
      throw Refusal{tabbed, 1, "this line is indented with a tab, which YAML does not allow; indent it with spaces"};
    }
    throw Refusal{place.line, place.column,
                  "this is no YAML: " + error.msg + yaml_advice(text, place.line, place.column, error.msg)};
  }
  return std::move(builder.root);
}

/// A link is seen where it is, so it is told apart from a name that is wrong.
std::string why_missing(const std::filesystem::path& file) {
  std::error_code no_link;
  const std::filesystem::path target = std::filesystem::read_symlink(file, no_link);
  return no_link ? "no such file" : "this is a link to `" + target.string() + "`, which leads to no file";
}

Refusal unreadable(const std::error_code& reason) {
  return {1, 1, "the file cannot be read: " + reason.message()};
}

std::string read_bytes(const std::filesystem::path& file) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(file, failure);
  if (failure == std::errc::permission_denied) throw unreadable(failure);
  if (!std::filesystem::exists(status)) throw Refusal{1, 1, why_missing(file)};
  if (std::filesystem::is_directory(status)) throw Refusal{1, 1, "this is a directory, not a file"};
  if (!std::filesystem::is_regular_file(status)) throw Refusal{1, 1, "this is not a regular file"};
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw unreadable({errno, std::generic_category()});
  std::string text(static_cast<std::size_t>(kLargestFile) + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream && !stream.eof()) throw Refusal{1, 1, "the file cannot be read"};
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.starts_with("\x89HDF\r\n\x1A\n")) {
    throw Refusal{1, 1,
                  "this is an HDF5 file, as takes are, and no scenario; `thinwall render` makes pictures of a take"};
  }
  if (text.size() > kLargestFile) throw Refusal{1, 1, "the file is larger than 1 MiB"};
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  return text;
}

}  // namespace

std::optional<TextNode> read_yaml_text(const std::string& text, const std::filesystem::path& place,
                                       Diagnostics& diagnostics) {
  try {
    return parse(text, place, diagnostics);
  } catch (const Refusal& refusal) {
    diagnostics.error({place, refusal.line, refusal.column}, "", refusal.message);
    return std::nullopt;
  }
}

std::optional<TextNode> read_yaml_file(const std::filesystem::path& file, Diagnostics& diagnostics) {
  try {
    return read_yaml_text(read_bytes(file), file, diagnostics);
  } catch (const Refusal& refusal) {
    diagnostics.error({file, refusal.line, refusal.column}, "", refusal.message);
    return std::nullopt;
  }
}

}  // namespace thinwall
