#include "studio/golden/ApprovalFile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "renderer/image/WholeFile.hpp"
#include "studio/scenario/YamlReader.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

using Json = ApprovalValue::Json;
using Step = ApprovalValue::Step;

/// "goldens[2].at_s", as paths in scenarios are told.
std::string told_path(const std::vector<Step>& steps) {
  std::string path;
  for (const Step& step : steps) {
    const auto* index = std::get_if<std::size_t>(&step);
    path = index != nullptr ? item_path(path, *index) : member_path(path, std::get<std::string>(step));
  }
  return path;
}

/// Where the value stands in the text, which as JSON is YAML too; the values above it where it is not there.
SourceLocation place_of(const TextNode& root, const std::vector<Step>& steps) {
  const TextNode* node = &root;
  for (const Step& step : steps) {
    const TextNode* next = nullptr;
    if (const auto* index = std::get_if<std::size_t>(&step)) {
      if (*index < node->items.size()) next = &node->items[*index];
    } else if (const TextMember* member = node->find(std::get<std::string>(step))) {
      next = &member->value;
    }
    if (next == nullptr) break;
    node = next;
  }
  return node->location;
}

/// The place of a byte of a text; counts from 1, as `byte` does.
SourceLocation place_of_byte(const std::filesystem::path& file, const std::string& text, std::size_t byte) {
  const std::string before = text.substr(0, std::max<std::size_t>(byte, 1) - 1);
  const std::size_t last_end = before.rfind('\n');
  const std::size_t column = last_end == std::string::npos ? before.size() : before.size() - last_end - 1;
  return {.file = file,
          .line = 1 + static_cast<int>(std::ranges::count(before, '\n')),
          .column = 1 + static_cast<int>(column)};
}

/// Where the mark of a merge stands that was given up midway: at the beginning of a line; npos where there is none.
std::size_t conflict_in(const std::string& text) {
  constexpr const char* kMark = "<<<<<<< ";
  if (text.starts_with(kMark)) return 0;
  const std::size_t end_of_line = text.find(std::string("\n") + kMark);
  return end_of_line == std::string::npos ? end_of_line : end_of_line + 1;
}

[[noreturn]] void refuse_text(const std::filesystem::path& file, const std::string& text, std::size_t byte) {
  if (const std::size_t mark = conflict_in(text); mark != std::string::npos) {
    throw GoldenError(
        fmt::format("{}: is damaged: a conflict of a merge begins here; take the folder {} whole from one side (git "
                    "checkout --ours or --theirs), or approve anew",
                    to_text(place_of_byte(file, text, mark + 1)), file.parent_path().string()));
  }
  const bool is_cut_off = byte > text.size();
  const std::string what = is_cut_off
                               ? "the file ends in the middle"
                               : fmt::format("JSON does not go on with {} here", spelled_out(text.substr(byte - 1, 1)));
  throw damaged_golden(to_text(place_of_byte(file, text, byte)) + ": is damaged: " + what);
}

Json parsed(const std::filesystem::path& file, const std::string& text) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    refuse_text(file, text, error.byte);
  }
}

}  // namespace

void ApprovalValue::refuse(const char* state, const std::string& what) const {
  Diagnostics ignored;
  const TextNode root = read_yaml_text(file_.text(), file_.path(), ignored).value_or(TextNode{});
  const std::string path = told_path(path_);
  throw damaged_golden(to_text(place_of(root, path_)) + ": " + state + (path.empty() ? "" : path + ": ") + what);
}

void ApprovalValue::refuse_kind(const char* expected) const {
  const std::string found = json_.is_array() ? "a list" : json_.is_object() ? "keys and values" : json_.dump();
  refuse(fmt::format("expected {}, got {}", expected, found));
}

ApprovalValue ApprovalValue::at(const std::string& key) const {
  if (!json_.is_object()) refuse_kind("keys and values between braces");
  if (!json_.contains(key)) refuse(in_backticks(key) + " is missing");
  std::vector<Step> path = path_;
  path.emplace_back(key);
  return {file_, json_.at(key), std::move(path)};
}

std::string ApprovalValue::dump(const std::string& key) const {
  return at(key).json_.dump();
}

bool ApprovalValue::has(const std::string& key) const {
  return json_.is_object() && json_.contains(key);
}

std::vector<std::string> ApprovalValue::texts(const std::string& key) const {
  std::vector<std::string> texts;
  for (const ApprovalValue& item : list(key)) texts.push_back(item.as_text());
  return texts;
}

std::string ApprovalValue::as_text() const {
  if (!json_.is_string()) refuse_kind("a text");
  return json_.get<std::string>();
}

double ApprovalValue::as_number() const {
  if (!json_.is_number()) refuse_kind("a number");
  return json_.get<double>();
}

std::size_t ApprovalValue::as_count() const {
  if (!json_.is_number_unsigned()) refuse_kind("a whole number from 0");
  return json_.get<std::size_t>();
}

std::vector<ApprovalValue> ApprovalValue::as_list() const {
  if (!json_.is_array()) refuse_kind("a list");
  std::vector<ApprovalValue> items;
  for (std::size_t i = 0; i < json_.size(); ++i) {
    std::vector<Step> path = path_;
    path.emplace_back(i);
    items.emplace_back(file_, json_[i], std::move(path));
  }
  return items;
}

ApprovalFile::ApprovalFile(const std::filesystem::path& file, const std::string& version_key, int version)
    : path_(file) {
  if (!std::filesystem::is_regular_file(file)) throw damaged_golden(file.string() + ": is no file");
  text_ = bytes_of_file(file);
  json_ = std::make_shared<const Json>(parsed(file, text_));
  const ApprovalValue told = root().at(version_key);
  if (told.as_number() != version) {
    told.refuse_version(fmt::format("written by another version of the program: this one reads version {}", version));
  }
}

}  // namespace thinwall
