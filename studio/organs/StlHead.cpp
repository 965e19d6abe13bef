#include "studio/organs/StlHead.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string_view>
#include <system_error>

namespace thinwall {
namespace {

constexpr std::size_t kHead = 84, kTriangle = 50;  // bytes

bool is_named_stl(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return extension == ".stl";
}

}  // namespace

std::optional<StlHead> binary_stl_head(const std::filesystem::path& file) {
  if (!is_named_stl(file)) return std::nullopt;
  std::array<char, 512> beginning = {};
  std::ifstream stream(file, std::ios::binary);
  stream.read(beginning.data(), beginning.size());
  const std::string_view text(beginning.data(), static_cast<std::size_t>(stream.gcount()));
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || text.size() < kHead || text.find("facet") != std::string_view::npos) return std::nullopt;
  StlHead head;
  for (int k = 3; k >= 0; --k) head.announced = head.announced << 8U | static_cast<unsigned char>(text[80 + k]);
  head.present = (size - kHead) / kTriangle;
  const std::uintmax_t whole = kHead + std::uintmax_t{head.announced} * kTriangle;
  if (head.announced > 0 && size > whole) head.bytes_behind = size - whole;
  return head;
}

std::optional<std::string> shortened_stl(const std::filesystem::path& file) {
  const std::optional<StlHead> head = binary_stl_head(file);
  if (!head || head->bytes_behind == 0) return std::nullopt;
  std::string bytes(kHead + std::size_t{head->announced} * kTriangle, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return stream ? std::optional(bytes) : std::nullopt;
}

}  // namespace thinwall
