#pragma once

#include <cstdint>
#include <filesystem>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// What the ffprobe program finds in the first video track of a file.
struct VideoProbe {
  ImageSize size;
  std::int64_t frames = 0;  // counted, not taken from the header
  double duration = 0;      // seconds
};

/// Throws PictureFailure with ffprobe's own words when the file is no readable video or ffprobe is not there.
VideoProbe probe_video(const std::filesystem::path& path);

}  // namespace thinwall
