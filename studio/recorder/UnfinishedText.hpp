#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace thinwall {

/// A text file that grows under its unfinished name and gets its name when it is whole.
class UnfinishedText {
 public:
  /// Throws PictureFailure when it cannot be made.
  explicit UnfinishedText(std::filesystem::path target);

  /// Throws PictureFailure when the text cannot be kept. Short texts may be refused only at the next call or at
  /// finish().
  void write(std::string_view text);

  /// Gives the file its name. Throws PictureFailure; then there is no new file of that name.
  void finish();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path target_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace thinwall
