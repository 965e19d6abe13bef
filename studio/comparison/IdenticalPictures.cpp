#include "studio/comparison/IdenticalPictures.hpp"

#include <cstdint>
#include <string>
#include <system_error>

#include "renderer/image/PngParts.hpp"
#include "renderer/image/WholeFile.hpp"

namespace thinwall {
namespace {

constexpr std::uintmax_t kMostBytes = 1 << 28;  // of a file that is read as a whole

std::string bytes_of(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) ? bytes_of_file(path) : "";
}

}  // namespace

std::optional<ImageSize> identical_pictures(const std::filesystem::path& first, const std::filesystem::path& second) {
  std::error_code error;
  const std::uintmax_t length = std::filesystem::file_size(first, error);
  if (error || length > kMostBytes || length != std::filesystem::file_size(second, error) || error) return std::nullopt;
  const std::string bytes = bytes_of(first);
  if (bytes.empty() || bytes != bytes_of(second)) return std::nullopt;
  return size_of_whole_png(bytes);
}

}  // namespace thinwall
