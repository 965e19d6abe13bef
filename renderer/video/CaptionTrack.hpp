#pragma once

#include <filesystem>

namespace thinwall {

/// Marks the caption tracks of an MP4 file as not enabled, so that players list them but show them only when asked:
/// the captions are in the picture already. ffmpeg enables the first track of each kind whatever it is told. Clears the
/// lowest flag of the track headers (ISO/IEC 14496-12, box `tkhd`) whose handler is `sbtl`. Throws PictureFailure when
/// the file is no MP4 or cannot be changed.
void disable_caption_tracks(const std::filesystem::path& path);

}  // namespace thinwall
