#include "studio/recorder/FolderLock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "renderer/image/Folder.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"

namespace thinwall {
namespace {

[[noreturn]] void fail(const std::filesystem::path& folder, int code) {
  throw PictureFailure("cannot write to the folder " + folder.string() + ": " + std::generic_category().message(code) +
                       "; " + cure_for_write_error(code));
}

/// The run before may have removed the file between its opening and its locking.
bool is_still_there(const std::filesystem::path& file, int descriptor) {
  struct stat named = {};
  struct stat held = {};
  return ::stat(file.c_str(), &named) == 0 && ::fstat(descriptor, &held) == 0 && named.st_dev == held.st_dev &&
         named.st_ino == held.st_ino;
}

/// Of the file, locked.
int locked_descriptor(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  while (true) {
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(folder, errno);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      const int code = errno;
      ::close(descriptor);
      if (code != EWOULDBLOCK) fail(folder, code);
      throw FolderInUse("another run, process " + bytes_of_file(file) + ", works in " + folder.string() +
                        "; wait until it has ended, or choose another folder with --out");
    }
    if (is_still_there(file, descriptor)) return descriptor;
    ::close(descriptor);
  }
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : file_(folder / ".in_use") {
  make_folder(folder);
  descriptor_ = locked_descriptor(file_);
  const std::string process = std::to_string(::getpid());
  const bool is_told = ::ftruncate(descriptor_, 0) == 0 &&
                       ::write(descriptor_, process.data(), process.size()) == static_cast<ssize_t>(process.size());
  if (is_told) return;
  const int code = errno;
  ::close(descriptor_);
  fail(folder, code);
}

FolderLock::~FolderLock() {
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

}  // namespace thinwall
