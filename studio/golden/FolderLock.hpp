#pragma once

#include <filesystem>

namespace thinwall {

/// Holds a folder for one run while it lives, so that no two runs write into the same files. The system releases it
/// also when the process is killed.
class FolderLock {
 public:
  /// Makes the folder when it is not there. Throws GoldenError when another process holds it, and PictureFailure when
  /// nothing can be written there.
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int descriptor_ = -1;
};

}  // namespace thinwall
