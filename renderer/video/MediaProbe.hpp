#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// What the ffprobe program finds in a file with pictures: a still, an animation or a video, of anyone's making.
struct MediaProbe {
  std::string codec;         // "h264", "mjpeg", "gif", ...
  std::string pixel_format;  // as ffmpeg calls it: "yuv420p", "rgb48be", ...
  ImageSize size;
  std::vector<double> times;  // of the frames, seconds, ascending
  std::string color;          // range, matrix, primaries, transfer, as tagged: "tv bt709 bt709 bt709"
  std::string chapters;       // a line each: begin, end, title
  bool has_captions = false;
};

/// Only formats that hold pictures are tried, and only the file itself is opened: no list of other files, no network,
/// no text drawn as a picture. Throws ImageUnreadable with ffprobe's words; PictureFailure when there is no ffprobe.
MediaProbe probe_media(const std::filesystem::path& path);

/// The captions of the first caption track as WebVTT text; empty when there is none. Throws as `probe_media`.
std::string read_captions(const std::filesystem::path& path);

/// Options of ffmpeg and ffprobe that keep them to files with pictures, to stand before `-i`.
std::vector<std::string> picture_input_options();

}  // namespace thinwall
