#include "renderer/image/Folder.hpp"

#include <system_error>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"

namespace thinwall {
namespace {

void check(const std::error_code& error, const std::filesystem::path& folder) {
  if (!error) return;
  throw PictureFailure("cannot make the folder " + folder.string() + ": " + error.message() + "; " +
                       cure_for_write_error(error.value()));
}

}  // namespace

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  check(error, folder);
}

void rename_folder(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  check(error, to);
}

}  // namespace thinwall
