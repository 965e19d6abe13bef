#include "renderer/image/WholeFile.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

constexpr int kAttempts = 2;  // an unfinished file of an earlier, killed run is removed once

[[noreturn]] void fail(const std::filesystem::path& path, int code) {
  throw FileUnwritable("cannot write " + path.string() + ": " + std::generic_category().message(code) + "; " +
                       cure_for_write_error(code));
}

/// Removes the file at the end unless it was released.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const std::filesystem::path& name) : name_(name) {
    // Removing first keeps a leftover's owner, permissions and links out of the new file.
    for (int attempt = 0; attempt < kAttempts && descriptor_ < 0; ++attempt) {
      descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno == EEXIST) ::unlink(name_.c_str());
    }
  }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (created_ && !released_) ::unlink(name_.c_str());
  }

  bool open() {
    created_ = descriptor_ >= 0;
    return created_;
  }

  bool write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
  }

  /// Some file systems report a full disk only here.
  bool close() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    return ::close(descriptor) == 0;
  }

  void release() { released_ = true; }

 private:
  const std::filesystem::path& name_;
  int descriptor_ = -1;
  bool created_ = false;
  bool released_ = false;
};

}  // namespace

std::filesystem::path unfinished_name(const std::filesystem::path& path) {
  std::filesystem::path name = path;
  name.replace_filename(path.stem().string() + ".unfinished" + path.extension().string());
  return name;
}

std::string cure_for_write_error(int code) {
  switch (code) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some space or choose a folder on another disk";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a folder that you may write to";
    case ENOENT:
    case ENOTDIR:
      return "make the folder first or choose another";
    case EISDIR:
    case ENOTEMPTY:
    case EEXIST:
      return "a folder has this name; choose another name";
    case ENAMETOOLONG:
      return "choose a shorter name";
    default:
      return "check the disk or choose another folder";
  }
}

std::span<const std::uint8_t> as_numbers(std::string_view bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

std::string bytes_of_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t length = std::filesystem::file_size(path, error);
  if (error) return "";
  std::string bytes(length, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(length));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

namespace {

/// Whether there is something that bytes are sent to, as `/dev/null`, `/dev/full` or a pipe, and not kept in.
bool is_passage(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  return std::filesystem::is_character_file(status) || std::filesystem::is_fifo(status);
}

void send(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  std::FILE* passage = std::fopen(path.c_str(), "we");
  if (passage == nullptr) fail(path, errno);
  const bool is_sent = std::fwrite(bytes.data(), 1, bytes.size(), passage) == bytes.size();
  const int code = errno;
  if (std::fclose(passage) != 0) fail(path, errno);
  if (!is_sent) fail(path, code);
}

}  // namespace

void write_whole_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  if (is_passage(path)) return send(path, bytes);
  const std::filesystem::path unfinished = unfinished_name(path);
  UnfinishedFile file(unfinished);
  if (!file.open()) fail(path, errno);
  if (!file.write(bytes)) fail(path, errno);
  if (!file.close()) fail(path, errno);
  if (::rename(unfinished.c_str(), path.c_str()) != 0) fail(path, errno);
  file.release();
}

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
  write_whole_file(path, as_numbers(text));
}

}  // namespace thinwall
