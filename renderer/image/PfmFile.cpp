#include "renderer/image/PfmFile.hpp"

#include <bit>
#include <cctype>
#include <charconv>
#include <string_view>

#include "renderer/image/PngFile.hpp"

namespace thinwall {
namespace {

/// Words of the header, one after the other.
class HeaderWords {
 public:
  explicit HeaderWords(std::string_view text) : text_(text) {}

  template <typename Number>
  bool next(Number& number) {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    const auto result = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    return result.ec == std::errc();
  }
  std::size_t place() const { return at_; }

 private:
  std::string_view text_;
  std::size_t at_ = 2;  // behind the two letters
};

float number_at(const std::uint8_t* bytes, bool little_endian) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits |= static_cast<std::uint32_t>(bytes[little_endian ? i : 3 - i]) << (8 * i);
  return std::bit_cast<float>(bits);
}

}  // namespace

bool is_pfm(std::span<const std::uint8_t> bytes) {
  return bytes.size() > 3 && bytes[0] == 'P' && (bytes[1] == 'F' || bytes[1] == 'f') && std::isspace(bytes[2]) != 0;
}

FloatImage decode_pfm(std::span<const std::uint8_t> bytes, const std::string& name) {
  const auto refuse = [&](const std::string& why) { throw ImageUnreadable("cannot read " + name + ": " + why); };
  if (!is_pfm(bytes)) refuse("not a portable float map");
  HeaderWords words({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  FloatImage image{.size = {0, 0}, .channels = bytes[1] == 'F' ? 3 : 1, .values = {}};
  double scale = 0;
  if (!words.next(image.size.width) || !words.next(image.size.height) || !words.next(scale) || image.size.width <= 0 ||
      image.size.height <= 0 || scale == 0) {
    refuse("the header of this float map makes no sense");
  }
  const std::int64_t pixels = static_cast<std::int64_t>(image.size.width) * image.size.height;
  if (pixels > kLargestPngPixels) refuse("it claims to hold more pixels than are allowed");
  const std::size_t row = static_cast<std::size_t>(image.size.width) * static_cast<std::size_t>(image.channels);
  const std::size_t begin = words.place() + 1;  // one space behind the header
  const std::size_t count = row * static_cast<std::size_t>(image.size.height);
  if (bytes.size() < begin + 4 * count) refuse("this float map is cut short");
  image.values.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t y = static_cast<std::size_t>(image.size.height) - 1 - i / row;
    image.values[y * row + i % row] = number_at(&bytes[begin + 4 * i], scale < 0);
  }
  return image;
}

}  // namespace thinwall
