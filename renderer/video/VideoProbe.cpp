#include "renderer/video/VideoProbe.hpp"

#include <charconv>
#include <string>
#include <string_view>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/video/Program.hpp"

namespace thinwall {
namespace {

/// The number behind "key=" in lines of "key=value"; false when there is none.
template <typename Number>
bool read_entry(std::string_view lines, std::string_view key, Number& value) {
  const std::string start = "\n" + std::string(key) + "=";
  const std::string text = "\n" + std::string(lines);
  const std::size_t place = text.find(start);
  if (place == std::string::npos) return false;
  const char* begin = text.data() + place + start.size();
  return std::from_chars(begin, text.data() + text.size(), value).ec == std::errc();
}

}  // namespace

VideoProbe probe_video(const std::filesystem::path& path) {
  const ProgramResult result = run_program({"ffprobe", "-v", "error", "-select_streams", "v:0", "-count_packets",
                                            "-show_entries", "stream=width,height,nb_read_packets,duration", "-of",
                                            "default=noprint_wrappers=1", "file:" + path.string()});
  VideoProbe probe;
  const bool complete = result.exit_code == 0 && read_entry(result.output, "width", probe.size.width) &&
                        read_entry(result.output, "height", probe.size.height) &&
                        read_entry(result.output, "nb_read_packets", probe.frames) &&
                        read_entry(result.output, "duration", probe.duration);
  if (!complete) {
    throw PictureFailure("ffprobe finds no whole video in " + path.string() + ": " +
                         (result.errors.empty() ? "exit code " + std::to_string(result.exit_code) : result.errors));
  }
  return probe;
}

}  // namespace thinwall
