#include "renderer/video/MediaProbe.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "renderer/image/PngFile.hpp"
#include "renderer/video/Program.hpp"

namespace thinwall {
namespace {

constexpr const char* kFormats =
    "apng,asf,avi,bmp_pipe,dpx_pipe,exr_pipe,ffv1,flv,gif,h264,hevc,ico,image2,image2pipe,ivf,j2k_pipe,jpeg_pipe,"
    "jpegls_pipe,matroska,webm,mjpeg,mov,mp4,m4v,mpeg,mpegts,mpegvideo,mxf,nut,ogg,pam_pipe,pbm_pipe,pgm_pipe,"
    "pgmyuv_pipe,png_pipe,ppm_pipe,qoi_pipe,sgi_pipe,sunrast_pipe,tiff_pipe,webp_pipe,xwd_pipe,yuv4mpegpipe";

/// The values of `key` in lines of "key=value", in their order.
std::vector<std::string> values_of(std::string_view lines, std::string_view key) {
  std::vector<std::string> values;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(std::min(end + 1, lines.size()));
    if (line.size() > key.size() && line.starts_with(key) && line[key.size()] == '=') {
      values.emplace_back(line.substr(key.size() + 1));
    }
  }
  return values;
}

std::string first_of(const std::vector<std::string>& values) {
  return values.empty() ? "" : values.front();
}

template <typename Number>
Number number_of(const std::string& text) {
  Number number{};
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// ffmpeg's first line without the address of its part that speaks.
std::string first_words(const std::string& errors, int exit_code) {
  std::string line = errors.substr(0, errors.find('\n'));
  if (line.starts_with('[')) line.erase(0, std::min(line.find("] ") + 2, line.size()));
  return line.empty() ? "exit code " + std::to_string(exit_code) : line;
}

std::vector<std::string> command(const std::string& program, const std::vector<std::string>& options,
                                 const std::filesystem::path& path) {
  std::vector<std::string> arguments = {program, "-v", "error"};
  const std::vector<std::string> input = picture_input_options();
  arguments.insert(arguments.end(), input.begin(), input.end());
  arguments.insert(arguments.end(), {"-i", "file:" + path.string()});
  arguments.insert(arguments.end(), options.begin(), options.end());
  return arguments;
}

std::vector<double> frame_times(const std::string& output) {
  std::vector<double> times;
  for (const std::string& text : values_of(output, "pts_time")) {
    times.push_back(text == "N/A" ? static_cast<double>(times.size()) : number_of<double>(text));
  }
  // Frames are stored in the order of decoding.
  std::sort(times.begin(), times.end());
  return times;
}

std::string chapter_lines(const std::filesystem::path& path) {
  return run_program(command("ffprobe",
                             {"-show_chapters", "-show_entries", "chapter=start_time,end_time:chapter_tags=title",
                              "-of", "csv=p=0"},
                             path))
      .output;
}

}  // namespace

std::vector<std::string> picture_input_options() {
  return {"-protocol_whitelist", "file,pipe", "-format_whitelist", kFormats};
}

namespace {

/// What is wrong with a file in which no pictures were found. ffprobe's own words about formats that are not looked at
/// are a list of all others.
std::string why_nothing(const ProgramResult& result) {
  if (result.exit_code == 0) return "no picture or video in it can be decoded; it may be cut short";
  if (result.errors.find("whitelist") != std::string::npos) return "no picture or video";
  return "no picture or video that ffmpeg knows (" + first_words(result.errors, result.exit_code) + ")";
}

}  // namespace

MediaProbe probe_media(const std::filesystem::path& path) {
  const std::string entries =
      "stream=codec_name,width,height,pix_fmt,color_range,color_space,color_transfer,color_primaries:packet=pts_time";
  const ProgramResult result = run_program(command(
      "ffprobe", {"-select_streams", "v:0", "-show_entries", entries, "-of", "default=noprint_wrappers=1"}, path));
  if (result.exit_code != 0 || values_of(result.output, "codec_name").empty()) {
    throw ImageUnreadable("cannot read " + path.string() + ": " + why_nothing(result));
  }
  const auto text = [&](const char* key) { return first_of(values_of(result.output, key)); };
  MediaProbe probe{.codec = text("codec_name"),
                   .pixel_format = text("pix_fmt"),
                   .size = {number_of<int>(text("width")), number_of<int>(text("height"))},
                   .times = frame_times(result.output),
                   .color = text("color_range") + " " + text("color_space") + " " + text("color_primaries") + " " +
                            text("color_transfer"),
                   .chapters = "",
                   .has_captions = false};
  if (probe.size.width <= 0 || probe.size.height <= 0 || probe.times.empty()) {
    throw ImageUnreadable("cannot read " + path.string() + ": it holds no picture");
  }
  const std::int64_t pixels = static_cast<std::int64_t>(probe.size.width) * probe.size.height;
  if (pixels > kLargestPngPixels) {
    throw ImageUnreadable("cannot read " + path.string() + ": " + std::to_string(probe.size.width) + " x " +
                          std::to_string(probe.size.height) + " pixels are more than the " +
                          std::to_string(kLargestPngPixels) + " allowed");
  }
  if (probe.times.size() > 1) {
    probe.chapters = chapter_lines(path);
    const ProgramResult captions = run_program(command(
        "ffprobe", {"-select_streams", "s", "-show_entries", "stream=codec_name", "-of", "default=noprint_wrappers=1"},
        path));
    probe.has_captions = !values_of(captions.output, "codec_name").empty();
  }
  return probe;
}

std::string read_captions(const std::filesystem::path& path) {
  const ProgramResult result = run_program(command("ffmpeg", {"-map", "0:s:0?", "-f", "webvtt", "pipe:1"}, path));
  return result.exit_code == 0 ? result.output : "";
}

}  // namespace thinwall
