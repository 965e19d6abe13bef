#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/image/Layer.hpp"
#include "renderer/image/PictureFailure.hpp"

namespace thinwall {

/// A picture file that is missing, broken or no PNG: the user's input, not the disk's fault.
class ImageUnreadable : public PictureFailure {
 public:
  using PictureFailure::PictureFailure;
};

/// How much work goes into a small file. The pixels are the same.
enum class PngEffort {
  kFast,   // for frames: about 30 ms at 1280 x 720
  kSmall,  // for goldens, which are kept under version control: half as large, many times slower
};

/// The picture as 8-bit RGB PNG marked as sRGB. No times or texts inside: equal pictures give equal bytes.
/// The picture must not be empty. Throws PictureFailure when libpng refuses it.
std::vector<std::uint8_t> encode_png(const Image& image, PngEffort effort = PngEffort::kFast);

/// Whole numbers as PNG, 8 or 16 bits deep: grey for one channel, red, green and blue for three. No colour space is
/// named, so that readers leave the numbers as they are. Equal layers give equal bytes. Throws PictureFailure.
std::vector<std::uint8_t> encode_layer_png(const ByteLayer& layer);
std::vector<std::uint8_t> encode_layer_png(const WordLayer& layer);

/// The picture in the bytes of a PNG file: any bit depth, grey, palette, interlaced; as 8-bit colours with the numbers
/// of the file, whatever gamma it names, as those of videos and of all other pictures are read; alpha laid over white.
/// `name` is for the message only. Throws ImageUnreadable: no PNG, cut short, failed checksum, or more than
/// kLargestPngPixels.
Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// Writes the file as a whole or not at all. Throws PictureFailure.
void write_png(const std::filesystem::path& path, const Image& image, PngEffort effort = PngEffort::kFast);

/// Throws ImageUnreadable, also when there is no such file.
Image read_png(const std::filesystem::path& path);

/// A small file can claim to hold a picture that fills the memory.
inline constexpr std::int64_t kLargestPngPixels = 1 << 28;

}  // namespace thinwall
