#include "renderer/video/VideoWriter.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/video/CaptionTrack.hpp"
#include "renderer/video/Program.hpp"
#include "renderer/video/VideoProbe.hpp"
#include "renderer/video/WebVtt.hpp"
#include "renderer/video/YuvFrame.hpp"

namespace thinwall {
namespace {

namespace files = std::filesystem;

/// Frames per second as the fraction that the encoder counts in.
struct FrameRate {
  std::int64_t numerator = 30;
  std::int64_t denominator = 1;
  std::string text() const { return std::to_string(numerator) + "/" + std::to_string(denominator); }
};

FrameRate frame_rate(double frames_per_second) {
  constexpr std::int64_t kLargestUsual = 1001;  // 30000/1001 of television
  for (std::int64_t denominator = 1; denominator <= kLargestUsual; ++denominator) {
    const std::int64_t numerator = std::llround(frames_per_second * static_cast<double>(denominator));
    const double rate = static_cast<double>(numerator) / static_cast<double>(denominator);
    if (std::abs(rate - frames_per_second) <= 1e-9 * frames_per_second) return {numerator, denominator};
  }
  return {std::llround(frames_per_second * 1e6), 1000000};
}

std::string size_text(ImageSize size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

using Arguments = std::vector<std::string>;

void append(Arguments& arguments, Arguments more) {
  for (std::string& argument : more) arguments.push_back(std::move(argument));
}

/// Nothing of the machine in the file (no versions, no random identifiers), only errors on standard error.
Arguments ffmpeg_begin() {
  return {"ffmpeg", "-hide_banner", "-v", "error", "-y", "-fflags", "+bitexact"};
}

Arguments color_tags() {
  return {"-color_range",
          "tv",
          "-colorspace",
          "bt709",
          "-color_primaries",
          "bt709",
          "-color_trc",
          "bt709",
          "-chroma_sample_location",
          "left"};
}

/// Frames from standard input to a fragmented MP4, which is readable but for its last two seconds when all of us are
/// killed. Matroska would be too, but counts in milliseconds, and 33, 33, 34 ms are no constant frame times.
Arguments encoder_arguments(const VideoOptions& options, const files::path& recording) {
  const std::string rate = frame_rate(options.frames_per_second).text();
  const std::string second = std::to_string(std::max(1LL, std::llround(options.frames_per_second)));
  Arguments arguments = ffmpeg_begin();
  append(arguments,
         {"-f", "rawvideo", "-pix_fmt", "yuv420p", "-video_size", size_text(options.size), "-framerate", rate});
  append(arguments, color_tags());
  append(arguments, {"-i", "pipe:0", "-map", "0:v", "-c:v", "libx264", "-preset", "veryfast", "-crf", "18"});
  // The number of threads decides where the encoder may look for motion, so it must not be the machine's.
  append(arguments, {"-threads", "2", "-g", second, "-flags:v", "+bitexact"});
  // Nor may what its processor can do: left to itself the encoder takes other ways on another one.
  append(arguments, {"-x264-params", "cpu-independent=1"});
  append(arguments, color_tags());
  append(arguments, {"-fflags", "+bitexact", "-flush_packets", "1", "-movflags",
                     "+frag_keyframe+empty_moov+default_base_moof", "-f", "mp4", "file:" + recording.string()});
  return arguments;
}

struct RemuxFiles {
  files::path recording;
  files::path captions;
  files::path chapters;
  files::path result;
};

Arguments remux_arguments(const RemuxFiles& names, bool has_captions) {
  Arguments arguments = ffmpeg_begin();
  append(arguments,
         {"-i", "file:" + names.recording.string(), "-f", "ffmetadata", "-i", "file:" + names.chapters.string()});
  if (has_captions) append(arguments, {"-f", "webvtt", "-i", "file:" + names.captions.string()});
  append(arguments, {"-map", "0:v", "-map_metadata", "1", "-map_chapters", "1", "-c:v", "copy"});
  if (has_captions) append(arguments, {"-map", "2:s", "-c:s", "mov_text"});
  append(arguments, {"-fflags", "+bitexact", "-movflags", "+faststart", "-f", "mp4", "file:" + names.result.string()});
  return arguments;
}

/// A chapter list in ffmpeg's own metadata format, whose special characters are escaped with a backslash.
std::string chapter_metadata(const std::vector<VideoChapter>& chapters) {
  std::string text = ";FFMETADATA1\n";
  for (const VideoChapter& chapter : chapters) {
    text += "[CHAPTER]\nTIMEBASE=1/1000\nSTART=" + std::to_string(std::llround(chapter.begin * 1000)) +
            "\nEND=" + std::to_string(std::llround(chapter.end * 1000)) + "\ntitle=";
    for (const char c : chapter.title) {
      if (c == '=' || c == ';' || c == '#' || c == '\\' || c == '\n') text += '\\';
      text += c;
    }
    // The reader takes a line's last backslash for an escaped line end, even where it is escaped itself.
    text += chapter.title.ends_with('\\') ? " \n" : "\n";
  }
  return text;
}

/// Why ffmpeg could not write, from what it says; nothing where it says no such thing.
std::optional<int> write_error_in(const std::string& words) {
  const auto says = [&](const char* text) { return words.find(text) != std::string::npos; };
  if (says("No space left")) return ENOSPC;
  if (says("File too large")) return EFBIG;
  if (says("Disk quota")) return EDQUOT;
  if (says("Permission denied")) return EACCES;
  return std::nullopt;
}

/// What helps, from what ffmpeg says.
std::string cure_for(const std::string& words) {
  const auto says = [&](const char* text) { return words.find(text) != std::string::npos; };
  if (const std::optional<int> error = write_error_in(words)) return cure_for_write_error(*error);
  if (says("libx264")) return "install an ffmpeg that has the encoder libx264 (on Debian: apt-get install ffmpeg)";
  return "see what `thinwall doctor` says about video";
}

std::string one_line(std::string words) {
  while (!words.empty() && words.back() == '\n') words.pop_back();
  for (char& c : words) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return words;
}

std::string ending(const ProgramResult& result) {
  constexpr int kSignal = 128;
  const std::string words = one_line(result.errors);
  const std::string how = result.exit_code > kSignal ? "signal " + std::to_string(result.exit_code - kSignal)
                                                     : "exit code " + std::to_string(result.exit_code);
  return "(" + how + "): " + (words.empty() ? "it says nothing" : words) + "; " + cure_for(words);
}

}  // namespace

struct VideoWriter::Implementation {
  files::path target;
  VideoOptions options;
  RemuxFiles names;
  std::optional<Program> encoder;
  std::int64_t frames = 0;

  [[noreturn]] void fail(const std::string& reason) {
    encoder.reset();
    remove_temporary_files();
    throw PictureFailure("cannot record " + target.string() + ": " + reason);
  }

  /// Of what ffmpeg was doing when it ended, and how it ended.
  [[noreturn]] void fail(const std::string& doing, const ProgramResult& result) {
    try {
      fail(doing + " " + ending(result));
    } catch (const PictureFailure& failure) {
      if (write_error_in(result.errors)) throw FileUnwritable(failure.what());
      throw;
    }
  }

  void remove_temporary_files() const {
    std::error_code ignored;
    for (const files::path& name : {names.recording, names.captions, names.chapters, names.result}) {
      files::remove(name, ignored);
    }
  }

  void check_options() {
    if (options.size.width <= 0 || options.size.height <= 0 || options.size.width % 2 != 0 ||
        options.size.height % 2 != 0) {
      fail("a video's width and height must be even, not " + size_text(options.size) + "; choose " +
           size_text({std::max(2, options.size.width / 2 * 2), std::max(2, options.size.height / 2 * 2)}));
    }
  }

  /// Makes the recording's file, because ffmpeg would only say so when the first frames have been drawn.
  void check_folder() {
    std::error_code ignored;
    unlink(target.c_str());
    remove_temporary_files();
    const int file = open(names.recording.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    const int code = file < 0 ? errno : 0;
    if (file >= 0) close(file);
    if (code != 0) fail(std::generic_category().message(code) + "; " + cure_for_write_error(code));
    if (files::is_directory(target, ignored)) fail(cure_for_write_error(EISDIR));
  }

  void start() {
    check_options();
    check_folder();
    try {
      encoder.emplace(encoder_arguments(options, names.recording));
    } catch (const PictureFailure& failure) {
      fail(failure.what());
    }
  }

  void end_encoder() {
    const ProgramResult result = encoder->finish();
    encoder.reset();
    if (result.exit_code != 0) fail("ffmpeg failed", result);
  }

  void remux(const std::vector<VideoChapter>& chapters, const std::vector<VideoCaption>& captions) {
    // The tracks of this kind of file hold one text at a time: where the next begins, they forget what has not ended.
    const std::string captions_text = web_vtt(one_at_a_time(captions));
    const bool has_captions = captions_text != web_vtt({});
    write_whole_file(names.chapters, chapter_metadata(chapters));
    if (has_captions) write_whole_file(names.captions, captions_text);
    const ProgramResult result = run_program(remux_arguments(names, has_captions));
    // With a disk that is full when the file is ended, ffmpeg says so and reports success.
    if (result.exit_code != 0 || write_error_in(result.errors)) {
      fail("ffmpeg failed to finish the file", result);
    }
    if (has_captions) disable_caption_tracks(names.result);
  }

  /// ffmpeg may end early and still report success.
  void check_result() {
    VideoProbe probe;
    try {
      probe = probe_video(names.result);
    } catch (const PictureFailure& failure) {
      fail("ffmpeg reported success, but " + std::string(failure.what()));
    }
    const double duration = static_cast<double>(frames) / options.frames_per_second;
    if (probe.frames != frames || std::abs(probe.duration - duration) > 0.5 / options.frames_per_second) {
      fail("ffmpeg wrote " + std::to_string(probe.frames) + " of " + std::to_string(frames) + " frames, " +
           std::to_string(probe.duration) + " of " + std::to_string(duration) + " s, though it reported success");
    }
  }
};

VideoWriter::VideoWriter(files::path target, VideoOptions options)
    : implementation_(std::make_unique<Implementation>()) {
  assert(options.frames_per_second > 0);
  const auto beside = [&](const char* ending) {
    return target.parent_path() / (target.stem().string() + ".unfinished" + ending);
  };
  implementation_->names = {beside(".recording.mp4"), beside(".captions.vtt"), beside(".chapters.txt"), beside(".mp4")};
  implementation_->target = std::move(target);
  implementation_->options = options;
  implementation_->start();
}

VideoWriter::~VideoWriter() {
  implementation_->encoder.reset();
  implementation_->remove_temporary_files();
}

void VideoWriter::write(const Image& frame) {
  assert(frame.size == implementation_->options.size);
  assert(implementation_->encoder.has_value());
  if (implementation_->encoder->send(yuv420_bt709(frame))) {
    ++implementation_->frames;
    return;
  }
  const ProgramResult result = implementation_->encoder->finish();
  implementation_->fail("ffmpeg ended at frame " + std::to_string(implementation_->frames), result);
}

void VideoWriter::finish(const std::vector<VideoChapter>& chapters, const std::vector<VideoCaption>& captions) {
  Implementation& self = *implementation_;
  assert(self.encoder.has_value());
  if (self.frames == 0) self.fail("there are no frames");
  self.end_encoder();
  try {
    self.remux(chapters, captions);
    self.check_result();
    files::rename(self.names.result, self.target);
  } catch (const files::filesystem_error& error) {
    self.fail(error.code().message());
  }
  self.remove_temporary_files();
}

}  // namespace thinwall
