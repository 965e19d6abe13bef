#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// How the ffmpeg program hands over the pixels of a frame.
enum class FramePixels {
  kRgb8,       // (height x width x 3) bytes, sRGB or what the file holds
  kRgba8,      // (height x width x 4) bytes
  kRgba16,     // (height x width x 4) 16-bit numbers, little-endian
  kRgbFloat,   // (3 x height x width) 32-bit floats: planes of green, blue, red
  kGreyFloat,  // (height x width) 32-bit floats
};

/// Bytes of a frame.
std::size_t frame_bytes(ImageSize size, FramePixels pixels);

/// Reads the frames of a picture, an animation or a video one after the other, whatever ffmpeg decodes.
class FrameReader {
 public:
  /// `size` as `probe_media` tells it. Throws PictureFailure when there is no ffmpeg.
  FrameReader(const std::filesystem::path& path, ImageSize size, FramePixels pixels);

  /// The next frame into `frame`, which has the size of one. False at the end. Throws ImageUnreadable with ffmpeg's
  /// words when the file is cut short or damaged.
  bool next(std::span<std::uint8_t> frame);

  ~FrameReader();
  FrameReader(const FrameReader&) = delete;
  FrameReader& operator=(const FrameReader&) = delete;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace thinwall
