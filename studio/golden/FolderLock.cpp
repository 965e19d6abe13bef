#include "studio/golden/FolderLock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "renderer/image/Folder.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/picture/PictureFailure.hpp"
#include "studio/golden/GoldenApproval.hpp"

namespace thinwall {
namespace {

[[noreturn]] void fail(const std::filesystem::path& folder, int code) {
  throw PictureFailure("cannot write to the folder " + folder.string() + ": " + std::generic_category().message(code) +
                       "; " + cure_for_write_error(code));
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) {
  make_folder(folder);
  const std::filesystem::path file = folder / ".in_use";
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(folder, errno);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const int code = errno;
    ::close(descriptor_);
    if (code != EWOULDBLOCK) fail(folder, code);
    throw GoldenError("another golden run, process " + bytes_of_file(file) + ", works in " + folder.string() +
                      "; wait until it has ended, or choose another folder with --out");
  }
  const std::string process = std::to_string(::getpid());
  const bool is_told = ::ftruncate(descriptor_, 0) == 0 &&
                       ::write(descriptor_, process.data(), process.size()) == static_cast<ssize_t>(process.size());
  if (is_told) return;
  const int code = errno;
  ::close(descriptor_);
  fail(folder, code);
}

FolderLock::~FolderLock() {
  ::close(descriptor_);
}

}  // namespace thinwall
