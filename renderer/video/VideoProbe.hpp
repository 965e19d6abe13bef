#pragma once

#include <cstdint>
#include <filesystem>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// What the first video track of an MP4 file says of itself.
struct VideoProbe {
  ImageSize size;
  std::int64_t frames = 0;  // whose sizes are listed
  double duration = 0;      // seconds
};

/// Reads the boxes of the file (ISO/IEC 14496-12) rather than ask ffprobe, whose start alone takes as long as some
/// pictures do. Throws PictureFailure when the file is no MP4, is cut short or holds no video.
VideoProbe probe_video(const std::filesystem::path& path);

}  // namespace thinwall
