#include "renderer/image/PngFile.hpp"

#include <png.h>

#include <algorithm>
#include <cassert>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "renderer/image/PngParts.hpp"
#include "renderer/image/WholeFile.hpp"

namespace thinwall {
namespace {

/// Where libpng's callbacks put bytes and words. They are C, so no exception may pass through them.
struct PngSink {
  std::vector<std::uint8_t> bytes;
  char words[128] = "";
};

[[noreturn]] void keep_words_and_leave(png_structp png, png_const_charp words) {
  auto* sink = static_cast<PngSink*>(png_get_error_ptr(png));
  std::snprintf(sink->words, sizeof(sink->words), "%s", words);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void append_bytes(png_structp png, png_bytep data, std::size_t count) {
  auto* sink = static_cast<PngSink*>(png_get_io_ptr(png));
  bool out_of_memory = false;
  try {
    sink->bytes.insert(sink->bytes.end(), data, data + count);
  } catch (const std::bad_alloc&) {
    out_of_memory = true;
  }
  if (out_of_memory) png_error(png, "out of memory");
}

void flush_nothing(png_structp) {}

void set_effort(png_structp png, PngEffort effort) {
  // The difference to the left neighbour for all rows: on rendered pictures smaller and faster than any other filter,
  // at level 9 also than choosing a filter for each row.
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_compression_level(png, effort == PngEffort::kFast ? 1 : 9);
}

/// What libpng needs to know of a picture.
struct PngRows {
  ImageSize size;
  int bit_depth = 8;
  int color_type = PNG_COLOR_TYPE_RGB;
  bool is_srgb = true;
  const std::uint8_t* first = nullptr;
  std::size_t stride = 0;  // bytes from row to row
  PngEffort effort = PngEffort::kFast;
};

/// False when libpng left by longjmp. Holds no object with a destructor, which a longjmp would skip.
bool encode_rows(png_structp png, png_infop info, const PngRows& rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(png, info, static_cast<png_uint_32>(rows.size.width), static_cast<png_uint_32>(rows.size.height),
               rows.bit_depth, rows.color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (rows.is_srgb) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  set_effort(png, rows.effort);
  png_write_info(png, info);
  // The format stores the high byte first.
  if (rows.bit_depth == 16) png_set_swap(png);
  for (int row = 0; row < rows.size.height; ++row) {
    png_write_row(png, rows.first + static_cast<std::size_t>(row) * rows.stride);
  }
  png_write_end(png, nullptr);
  return true;
}

/// Frees libpng's structures also when an exception passes.
struct PngWriter {
  png_structp png = nullptr;
  png_infop info = nullptr;
  explicit PngWriter(PngSink& sink)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, keep_words_and_leave, ignore_warning)),
        info(png ? png_create_info_struct(png) : nullptr) {}
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

std::string bytes_of_picture(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw ImageUnreadable("cannot read " + path.string() + ": no such file");
  if (std::filesystem::is_directory(path, error)) {
    throw ImageUnreadable("cannot read " + path.string() + ": it is a folder, not a picture");
  }
  std::string bytes = bytes_of_file(path);
  if (bytes.empty() && std::filesystem::file_size(path, error) > 0) {
    throw ImageUnreadable("cannot read " + path.string() + ": permission denied or disk error");
  }
  return bytes;
}

/// png_image must be freed on every way out.
struct PngReader {
  png_image image{};
  PngReader() { image.version = PNG_IMAGE_VERSION; }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_image_free(&image); }
};

std::vector<std::uint8_t> encode(const PngRows& rows) {
  PngSink sink;
  sink.bytes.reserve(rows.stride * static_cast<std::size_t>(rows.size.height) / 4);
  PngWriter writer(sink);
  if (writer.info == nullptr) throw PictureFailure("cannot make a PNG picture: out of memory");
  png_set_write_fn(writer.png, &sink, append_bytes, flush_nothing);
  if (!encode_rows(writer.png, writer.info, rows)) {
    throw PictureFailure(std::string("cannot make a PNG picture: ") + sink.words);
  }
  return std::move(sink.bytes);
}

template <typename Number>
PngRows rows_of(const Layer<Number>& layer) {
  const std::size_t numbers = static_cast<std::size_t>(layer.size.width) * layer.channels;
  assert(layer.channels == 1 || layer.channels == 3);
  assert(layer.values.size() == numbers * static_cast<std::size_t>(layer.size.height));
  return {.size = layer.size,
          .bit_depth = 8 * sizeof(Number),
          .color_type = layer.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB,
          .is_srgb = false,
          .first = reinterpret_cast<const std::uint8_t*>(layer.values.data()),
          .stride = numbers * sizeof(Number)};
}

constexpr std::uint8_t kPngSignature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

void check_signature(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (bytes.empty()) throw ImageUnreadable("cannot read " + name + ": the file is empty");
  constexpr std::string_view kPointer = "version https://git-lfs";
  if (bytes.size() > kPointer.size() && std::memcmp(bytes.data(), kPointer.data(), kPointer.size()) == 0) {
    throw ImageUnreadable("cannot read " + name +
                          ": a pointer of Git LFS stands in place of the picture, which `git lfs pull` fetches");
  }
  if (bytes.size() < sizeof(kPngSignature) || std::memcmp(bytes.data(), kPngSignature, sizeof(kPngSignature)) != 0) {
    throw ImageUnreadable("cannot read " + name + ": not a PNG picture; save it as PNG");
  }
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, PngEffort effort) {
  assert(image.size.width > 0 && image.size.height > 0);
  assert(image.pixels.size() == static_cast<std::size_t>(image.size.width) * image.size.height * 3);
  return encode({.size = image.size,
                 .first = image.pixels.data(),
                 .stride = 3 * static_cast<std::size_t>(image.size.width),
                 .effort = effort});
}

std::vector<std::uint8_t> encode_layer_png(const ByteLayer& layer) {
  return encode(rows_of(layer));
}

std::vector<std::uint8_t> encode_layer_png(const WordLayer& layer) {
  return encode(rows_of(layer));
}

Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  check_signature(bytes, name);
  const std::vector<std::uint8_t> plain = without_gamma(bytes);
  PngReader reader;
  const auto broken = [&] {
    return ImageUnreadable("cannot read " + name + ": broken PNG picture (" + reader.image.message + ")");
  };
  if (png_image_begin_read_from_memory(&reader.image, plain.data(), plain.size()) == 0) throw broken();
  const std::int64_t width = reader.image.width;
  const std::int64_t height = reader.image.height;
  if (width * height > kLargestPngPixels) {
    throw ImageUnreadable("cannot read " + name + ": " + std::to_string(width) + " x " + std::to_string(height) +
                          " pixels are more than the " + std::to_string(kLargestPngPixels) + " allowed");
  }
  reader.image.format = PNG_FORMAT_RGB;
  reader.image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  Image image{.size = {static_cast<int>(width), static_cast<int>(height)}, .pixels = {}};
  image.pixels.resize(PNG_IMAGE_SIZE(reader.image));
  const png_color white{255, 255, 255};
  if (png_image_finish_read(&reader.image, &white, image.pixels.data(), 0, nullptr) == 0) throw broken();
  // All pixels are there, but whatever wrote the file did not come to its end.
  if (!has_png_end(bytes)) throw ImageUnreadable("cannot read " + name + ": cut short (its end mark is missing)");
  return image;
}

void write_png(const std::filesystem::path& path, const Image& image, PngEffort effort) {
  write_whole_file(path, encode_png(image, effort));
}

Image read_png(const std::filesystem::path& path) {
  return decode_png(as_numbers(bytes_of_picture(path)), path.string());
}

}  // namespace thinwall
