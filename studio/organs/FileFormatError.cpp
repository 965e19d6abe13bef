#include "studio/organs/FileFormatError.hpp"

#include <fmt/core.h>

#include <fstream>
#include <iterator>

namespace thinwall {

std::string read_file_bytes(const std::filesystem::path& file, std::uintmax_t most) {
  std::error_code failure;
  if (!std::filesystem::exists(file, failure)) throw FileFormatError(file, 1, 1, "there is no such file");
  if (!std::filesystem::is_regular_file(file, failure)) throw FileFormatError(file, 1, 1, "it is not a file");
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  if (failure || size > most) {
    throw FileFormatError(file, 1, 1, fmt::format("it is larger than the {} bytes that are read", most));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileFormatError(file, 1, 1, "it may not be read: permission denied");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace thinwall
