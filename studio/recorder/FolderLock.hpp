#pragma once

#include <filesystem>
#include <stdexcept>

namespace thinwall {

/// Another process writes where this one was to write.
class FolderInUse : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Holds a folder for one run while it lives, so that no two runs write into the same files, by a file `.in_use` with
/// the number of the process, which goes with the lock. The system releases it also when the process is killed.
class FolderLock {
 public:
  /// Makes the folder when it is not there. Throws FolderInUse when another process holds it, and PictureFailure when
  /// nothing can be written there.
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace thinwall
