#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/video/VideoWriter.hpp"

namespace thinwall {

/// The captions as a WebVTT file (W3C WebVTT: The Web Video Text Tracks Format), times in milliseconds. Captions
/// without text or of no length are left out, because the format has no place for them.
std::string web_vtt(const std::vector<VideoCaption>& captions);

/// The captions without overlap: of those that hold at a time the last, which the pictures show, and again the one
/// before once that has ended.
std::vector<VideoCaption> one_at_a_time(const std::vector<VideoCaption>& captions);

/// Writes the captions `one_at_a_time` as a whole file: players would show those that overlap at once. Throws
/// PictureFailure.
void write_web_vtt(const std::filesystem::path& path, const std::vector<VideoCaption>& captions);

}  // namespace thinwall
