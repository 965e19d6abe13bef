#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "renderer/image/FloatImage.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/metric/DeepDifference.hpp"
#include "renderer/video/MediaProbe.hpp"

namespace thinwall {

enum class MediaKind {
  kPicture,    // one picture of 8 or 16 bits, with or without transparency
  kHighRange,  // one picture of floating-point numbers
  kVideo,      // several pictures one after the other: a video or an animation
};

/// "picture", "picture of high range", "video"
std::string kind_name(MediaKind kind);

/// A file with pictures, read but for the frames of a video.
struct MediaFile {
  std::filesystem::path path;
  MediaKind kind = MediaKind::kPicture;
  Image image;                    // kPicture: 8-bit colours, transparency laid over white
  std::optional<DeepImage> deep;  // kPicture: when the file holds more than that
  FloatImage numbers;             // kHighRange: one or three channels
  MediaProbe probe;               // kVideo
  ImageSize size() const;
};

/// Reads PNG by itself and all else through the ffmpeg program. Throws ImageUnreadable with what is wrong: no such
/// file, a folder, empty, not a picture, cut short, damaged, too large, or colours of print (CMYK), which have no
/// colour on a screen without a profile. PictureFailure when ffmpeg is needed and not there.
MediaFile read_media(const std::filesystem::path& path);

}  // namespace thinwall
