#include "studio/comparison/PictureFile.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <span>
#include <system_error>
#include <vector>

#include "renderer/image/PfmFile.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/video/FrameReader.hpp"

namespace thinwall {
namespace {

using Bytes = std::vector<std::uint8_t>;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& words) {
  throw ImageUnreadable("cannot read " + path.string() + ": " + words);
}

void check_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::none) refuse(path, error.message());
  if (!std::filesystem::exists(status)) refuse(path, "no such file");
  if (std::filesystem::is_directory(status)) refuse(path, "it is a folder, not a picture");
  if (!std::filesystem::is_regular_file(status)) refuse(path, "it is no regular file");
  if (std::filesystem::file_size(path, error) == 0) refuse(path, "the file is empty");
}

/// Enough of a file to tell what it is.
Bytes beginning_of(const std::filesystem::path& path) {
  constexpr std::size_t kBeginning = 65536;
  std::ifstream file(path, std::ios::binary);
  Bytes bytes(kBeginning);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file.is_open() || file.bad()) refuse(path, "permission denied or disk error");
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

bool begins_with(const Bytes& bytes, std::initializer_list<int> signature) {
  return bytes.size() >= signature.size() &&
         std::equal(signature.begin(), signature.end(), bytes.begin(), [](int a, int b) { return a == b; });
}

std::uint32_t big_endian(const Bytes& bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count && at + i < bytes.size(); ++i) value = value << 8 | bytes[at + i];
  return value;
}

bool is_png(const Bytes& bytes) {
  return begins_with(bytes, {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
}

/// Whether the chunks before the picture's data name one of these types.
bool has_png_chunk(const Bytes& bytes, std::initializer_list<const char*> types) {
  for (std::size_t at = 8; at + 8 <= bytes.size();) {
    const char* type = reinterpret_cast<const char*>(&bytes[at + 4]);
    if (std::memcmp(type, "IDAT", 4) == 0) return false;
    for (const char* wanted : types) {
      if (std::memcmp(type, wanted, 4) == 0) return true;
    }
    at += 12 + static_cast<std::size_t>(big_endian(bytes, at, 4));
  }
  return false;
}

/// 8-bit colours without transparency, which libpng reads as they are.
bool is_plain_png(const Bytes& bytes) {
  constexpr std::size_t kDepth = 24;
  constexpr std::size_t kColorType = 25;
  if (!is_png(bytes) || bytes.size() <= kColorType) return is_png(bytes);
  const bool has_alpha = (bytes[kColorType] & 4) != 0;
  return bytes[kDepth] <= 8 && !has_alpha && !has_png_chunk(bytes, {"tRNS", "acTL"});
}

/// The number of colours in a JPEG's frame header; 0 when it is not found.
int jpeg_components(const Bytes& bytes) {
  for (std::size_t at = 2; at + 9 < bytes.size() && bytes[at] == 0xff;) {
    const int marker = bytes[at + 1];
    const bool is_frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (is_frame) return bytes[at + 9];
    at += 2 + big_endian(bytes, at + 2, 2);
  }
  return 0;
}

/// Whether a TIFF says that its colours are those of print: tag 262 with the value 5.
bool is_print_tiff(const Bytes& bytes) {
  const bool little = begins_with(bytes, {'I', 'I', 42, 0});
  if (!little && !begins_with(bytes, {'M', 'M', 0, 42})) return false;
  const auto number = [&](std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t place = little ? at + count - 1 - i : at + i;
      value = value << 8 | (place < bytes.size() ? bytes[place] : 0U);
    }
    return value;
  };
  const std::size_t directory = number(4, 4);
  for (std::size_t i = 0; i < number(directory, 2); ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    if (entry + 12 > bytes.size()) return false;
    if (number(entry, 2) == 262) return number(entry + 8, 2) == 5;
  }
  return false;
}

/// WebP's extended header (RFC 9649, section 2.7.1) tells of an animation by its second lowest flag.
bool is_animated_webp(const Bytes& bytes) {
  constexpr std::size_t kFlags = 20;
  return bytes.size() > kFlags && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
         std::memcmp(&bytes[8], "WEBPVP8X", 8) == 0 && (bytes[kFlags] & 2) != 0;
}

bool is_high_range(const MediaProbe& probe) {
  return probe.codec == "exr" || probe.pixel_format.find("f32") != std::string::npos;
}

/// Whether ffmpeg's name of a pixel format tells of more than 8 bits: "rgb48be", "gray16le", "yuv420p10le", "ya16be".
bool is_finer_than_8_bits(const std::string& format) {
  for (const char* depth : {"48", "64", "16", "14", "12le", "12be", "10le", "10be", "9le", "9be"}) {
    if (format.find(depth) != std::string::npos) return true;
  }
  return false;
}

bool has_alpha(const std::string& format) {
  for (const char* name : {"rgba", "bgra", "argb", "abgr", "ya8", "ya16", "yuva", "gbrap", "pal8"}) {
    if (format.find(name) != std::string::npos) return true;
  }
  return false;
}

Bytes only_frame(const std::filesystem::path& path, ImageSize size, FramePixels pixels) {
  FrameReader reader(path, size, pixels);
  Bytes frame(frame_bytes(size, pixels));
  if (!reader.next(frame)) refuse(path, "it holds no picture");
  // To the end, where damage behind the picture is told.
  Bytes rest(frame.size());
  reader.next(rest);
  return frame;
}

/// Without a conversion where there is a way: ffmpeg's own between 8 and 16 bits is not exact.
void read_colors(MediaFile& file) {
  const std::string& format = file.probe.pixel_format;
  const ImageSize size = file.probe.size;
  if (!is_finer_than_8_bits(format) && !has_alpha(format)) {
    file.image = {.size = size, .pixels = only_frame(file.path, size, FramePixels::kRgb8)};
    return;
  }
  DeepImage deep{.size = size, .values = {}};
  if (is_finer_than_8_bits(format)) {
    const Bytes frame = only_frame(file.path, size, FramePixels::kRgba16);
    for (std::size_t i = 0; i < frame.size(); i += 2) {
      deep.values.push_back(static_cast<std::uint16_t>(frame[i] | frame[i + 1] << 8));
    }
  } else {
    for (const std::uint8_t level : only_frame(file.path, size, FramePixels::kRgba8)) {
      deep.values.push_back(static_cast<std::uint16_t>(level * 257));
    }
  }
  file.image = flattened(deep);
  if (!is_plain(deep)) file.deep = std::move(deep);
}

FloatImage read_numbers(const std::filesystem::path& path, const MediaProbe& probe) {
  const bool grey = probe.pixel_format.starts_with("gray");
  const FramePixels pixels = grey ? FramePixels::kGreyFloat : FramePixels::kRgbFloat;
  const Bytes frame = only_frame(path, probe.size, pixels);
  std::vector<float> planes(frame.size() / 4);
  std::memcpy(planes.data(), frame.data(), frame.size());
  if (grey) return {.size = probe.size, .channels = 1, .values = std::move(planes)};
  FloatImage image{.size = probe.size, .channels = 3, .values = std::vector<float>(planes.size())};
  const std::size_t count = planes.size() / 3;
  constexpr std::size_t kPlaneOf[] = {2, 0, 1};  // red, green, blue among green, blue, red
  for (std::size_t i = 0; i < planes.size(); ++i) image.values[i] = planes[kPlaneOf[i % 3] * count + i / 3];
  return image;
}

}  // namespace

std::string kind_name(MediaKind kind) {
  switch (kind) {
    case MediaKind::kPicture:
      return "picture";
    case MediaKind::kHighRange:
      return "picture of high range";
    case MediaKind::kVideo:
      return "video";
  }
  return "";
}

ImageSize MediaFile::size() const {
  if (kind == MediaKind::kVideo) return probe.size;
  return kind == MediaKind::kHighRange ? numbers.size : image.size;
}

MediaFile read_media(const std::filesystem::path& path) {
  check_file(path);
  MediaFile file;
  file.path = path;
  const Bytes beginning = beginning_of(path);
  if (is_plain_png(beginning)) {
    file.image = read_png(path);
    return file;
  }
  if (is_pfm(beginning)) {
    file.kind = MediaKind::kHighRange;
    file.numbers = decode_pfm(as_numbers(bytes_of_file(path)), path.string());
    return file;
  }
  if (begins_with(beginning, {0xff, 0xd8}) && jpeg_components(beginning) == 4) {
    refuse(path, "its colours are those of print (CMYK); save it as RGB");
  }
  if (is_print_tiff(beginning)) refuse(path, "its colours are those of print (CMYK); save it as RGB");
  if (is_animated_webp(beginning)) {
    refuse(path, "it is an animated WebP, which the ffmpeg program cannot decode; save it as GIF or animated PNG");
  }
  // libpng tells of damage in clearer words, so it looks first.
  if (is_png(beginning)) file.image = read_png(path);
  file.probe = probe_media(path);
  if (file.probe.times.size() > 1) {
    file.kind = MediaKind::kVideo;
  } else if (is_high_range(file.probe)) {
    file.kind = MediaKind::kHighRange;
    file.numbers = read_numbers(path, file.probe);
  } else {
    read_colors(file);
  }
  return file;
}

}  // namespace thinwall
