#pragma once

#include <string>

namespace thinwall {

/// The first line that a program like ffmpeg prints about itself; empty when it cannot be run.
std::string program_version(const std::string& program);

/// Whether videos can be made here.
struct VideoSurvey {
  bool ffmpeg = false;
  bool ffprobe = false;
  bool libx264 = false;
  std::string ffmpeg_version;   // its own first line, e.g. "ffmpeg version 5.1.9-0+deb12u1 ..."; empty when missing
  std::string ffprobe_version;  // likewise
  std::string problem;          // why no video can be made and what helps; empty when all is there
};

/// Asks the programs themselves; throws nothing when they are missing.
VideoSurvey survey_video();

}  // namespace thinwall
