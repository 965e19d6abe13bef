#pragma once

#include "renderer/video/MediaProbe.hpp"
#include "studio/comparison/FileComparison.hpp"

namespace thinwall {

/// Compares two videos of equal size frame by frame as they are decoded, and their lengths, frame times, captions,
/// chapters and colour tags. `result` names the files and takes what is found.
void judge_videos(FileComparison& result, const MediaProbe& first, const MediaProbe& second,
                  const PictureOptions& pictures, const FileComparisonOptions& options);

}  // namespace thinwall
