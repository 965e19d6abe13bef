#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "studio/golden/GoldenApproval.hpp"

namespace thinwall {

class ApprovalFile;

/// A value in a file of approvals, read key by key. What is not as it should be is thrown as GoldenError, with file,
/// line, column, path and cure.
class ApprovalValue {
 public:
  using Json = nlohmann::ordered_json;
  using Step = std::variant<std::string, std::size_t>;  // a key, or an index from 0

  ApprovalValue(const ApprovalFile& file, const Json& json, std::vector<Step> path = {})
      : file_(file), json_(json), path_(std::move(path)) {}

  /// The values under a key that has to be there.
  ApprovalValue at(const std::string& key) const;
  std::string text(const std::string& key) const { return at(key).as_text(); }
  double number(const std::string& key) const { return at(key).as_number(); }
  std::size_t count(const std::string& key) const { return at(key).as_count(); }
  std::vector<ApprovalValue> list(const std::string& key) const { return at(key).as_list(); }
  std::vector<std::string> texts(const std::string& key) const;
  /// Any JSON, as its text.
  std::string dump(const std::string& key) const;

  bool has(const std::string& key) const;
  /// "" where the key is not there.
  std::string text_if_there(const std::string& key) const { return has(key) ? text(key) : ""; }

  std::string as_text() const;
  double as_number() const;
  std::size_t as_count() const;
  std::vector<ApprovalValue> as_list() const;

  /// Throws GoldenError: what is wrong at this place, where the file is damaged or of another program.
  [[noreturn]] void refuse(const std::string& what) const { refuse("is damaged: ", what); }
  [[noreturn]] void refuse_version(const std::string& what) const { refuse("", what); }

 private:
  [[noreturn]] void refuse(const char* state, const std::string& what) const;
  [[noreturn]] void refuse_kind(const char* expected) const;

  const ApprovalFile& file_;
  const Json& json_;
  std::vector<Step> path_;
};

/// The text of a file of approvals, JSON, with a version of its form.
class ApprovalFile {
 public:
  /// Throws GoldenError where it is no file or no JSON, or `version_key` tells another version.
  ApprovalFile(const std::filesystem::path& file, const std::string& version_key, int version);

  ApprovalValue root() const { return {*this, *json_}; }
  const std::filesystem::path& path() const { return path_; }
  const std::string& text() const { return text_; }

 private:
  std::filesystem::path path_;
  std::string text_;
  std::shared_ptr<const nlohmann::ordered_json> json_;
};

}  // namespace thinwall
