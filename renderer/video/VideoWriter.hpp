#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

struct VideoOptions {
  ImageSize size;
  double frames_per_second = 30;
};

struct VideoChapter {
  double begin = 0;  // seconds
  double end = 0;    // seconds
  std::string title;
};

struct VideoCaption {
  double begin = 0;  // seconds
  double end = 0;    // seconds
  std::string text;
};

/// Encodes frames with the ffmpeg program: H.264 yuv420p, BT.709 converted and tagged, constant frame times.
class VideoWriter {
 public:
  /// Records to a temporary file beside `target`. Throws PictureFailure (no program, no codec, no permission).
  VideoWriter(std::filesystem::path target, VideoOptions options);
  /// Without finish(): stops the encoder and removes the temporary files.
  ~VideoWriter();

  /// The size must be the one of the options. Throws PictureFailure with the encoder's own words when it has ended.
  void write(const Image& frame);

  /// Remuxes to mp4 with chapters, captions and fast start, checks frame count and duration, then gives the file its
  /// name. Throws PictureFailure; then there is no file of that name.
  void finish(const std::vector<VideoChapter>& chapters, const std::vector<VideoCaption>& captions);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace thinwall
