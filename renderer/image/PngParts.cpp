#include "renderer/image/PngParts.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace thinwall {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t kAroundChunk = 12;        // length, type and checksum of a part, four bytes each
constexpr std::uint64_t kMostPixels = 1 << 26;  // of what is taken for a picture without looking closer

template <typename Bytes>
std::uint32_t number_at(const Bytes& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = at; i < at + 4; ++i) number = number << 8 | static_cast<std::uint8_t>(bytes[i]);
  return number;
}

}  // namespace

std::optional<ImageSize> size_of_whole_png(const std::string& bytes) {
  if (!bytes.starts_with(kSignature)) return std::nullopt;
  ImageSize size;
  bool has_data = false;
  for (std::size_t at = kSignature.size(); at + kAroundChunk <= bytes.size();) {
    const std::size_t length = number_at(bytes, at);
    if (length > bytes.size() - at - kAroundChunk) return std::nullopt;
    const std::string_view type = std::string_view(bytes).substr(at + 4, 4);
    const auto checksum = crc32(0, reinterpret_cast<const Bytef*>(&bytes[at + 4]), static_cast<uInt>(length + 4));
    if (checksum != number_at(bytes, at + 8 + length) || type == "acTL") return std::nullopt;
    if (type == "IHDR" && length >= 8) {
      const std::uint32_t width = number_at(bytes, at + 8), height = number_at(bytes, at + 12);
      if (width == 0 || height == 0 || std::uint64_t{width} * height > kMostPixels) return std::nullopt;
      size = {.width = static_cast<int>(width), .height = static_cast<int>(height)};
    }
    has_data = has_data || (type == "IDAT" && length > 0);
    at += kAroundChunk + length;
    if (type == "IEND") return has_data && size.width > 0 && at == bytes.size() ? std::optional(size) : std::nullopt;
  }
  return std::nullopt;
}

std::vector<std::uint8_t> without_gamma(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kGamma = "gAMA";
  const auto kept = [&](std::size_t count) { return bytes.begin() + static_cast<std::ptrdiff_t>(count); };
  std::vector<std::uint8_t> others(bytes.begin(), kept(std::min(kSignature.size(), bytes.size())));
  std::size_t at = others.size();
  while (at + kAroundChunk <= bytes.size()) {
    const std::size_t end = at + kAroundChunk + number_at(bytes, at);
    if (end > bytes.size()) break;
    if (!std::ranges::equal(bytes.subspan(at + 4, 4), kGamma)) others.insert(others.end(), kept(at), kept(end));
    at = end;
  }
  others.insert(others.end(), kept(at), bytes.end());
  return others;
}

bool has_png_end(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, kAroundChunk> kEnd = {0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};
  std::size_t at = kSignature.size();
  while (at + kAroundChunk <= bytes.size()) {
    if (std::ranges::equal(bytes.subspan(at, kAroundChunk), kEnd)) return true;
    at += kAroundChunk + number_at(bytes, at);
  }
  return false;
}

}  // namespace thinwall
