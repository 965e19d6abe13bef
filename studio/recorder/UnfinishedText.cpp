#include "studio/recorder/UnfinishedText.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"

namespace thinwall {

UnfinishedText::UnfinishedText(std::filesystem::path target)
    : target_(std::move(target)), file_(std::fopen(unfinished_name(target_).c_str(), "we"), std::fclose) {
  if (!file_) fail();
}

void UnfinishedText::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
}

void UnfinishedText::finish() {
  // Some file systems report a full disk only when the file is closed.
  if (std::fflush(file_.get()) != 0 || std::fclose(file_.release()) != 0) fail();
  std::error_code error;
  std::filesystem::rename(unfinished_name(target_), target_, error);
  if (error) {
    errno = error.value();
    fail();
  }
}

void UnfinishedText::fail() const {
  const int code = errno;
  throw PictureFailure("cannot write " + target_.string() + ": " + std::generic_category().message(code) + "; " +
                       cure_for_write_error(code));
}

}  // namespace thinwall
