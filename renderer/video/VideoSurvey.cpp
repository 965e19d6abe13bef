#include "renderer/video/VideoSurvey.hpp"

#include "renderer/image/PictureFailure.hpp"
#include "renderer/video/Program.hpp"

namespace thinwall {

std::string program_version(const std::string& program) {
  try {
    const ProgramResult result = run_program({program, "-hide_banner", "-version"});
    return result.exit_code == 0 ? result.output.substr(0, result.output.find('\n')) : "";
  } catch (const PictureFailure&) {
    return "";
  }
}

VideoSurvey survey_video() {
  VideoSurvey survey;
  survey.ffmpeg_version = program_version("ffmpeg");
  survey.ffprobe_version = program_version("ffprobe");
  survey.ffmpeg = !survey.ffmpeg_version.empty();
  survey.ffprobe = !survey.ffprobe_version.empty();
  if (survey.ffmpeg) {
    const ProgramResult result = run_program({"ffmpeg", "-hide_banner", "-v", "error", "-encoders"});
    survey.libx264 = result.output.find(" libx264 ") != std::string::npos;
  }
  if (!survey.ffmpeg || !survey.ffprobe) {
    survey.problem = std::string("the program ") + (survey.ffmpeg ? "ffprobe" : "ffmpeg") +
                     " cannot be run; install it (on Debian: apt-get install ffmpeg)";
  } else if (!survey.libx264) {
    survey.problem = "this ffmpeg has no encoder libx264; install one that has it (on Debian: apt-get install ffmpeg)";
  }
  return survey;
}

}  // namespace thinwall
