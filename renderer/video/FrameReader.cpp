#include "renderer/video/FrameReader.hpp"

#include <algorithm>

#include "renderer/image/PngFile.hpp"
#include "renderer/video/MediaProbe.hpp"
#include "renderer/video/Program.hpp"

namespace thinwall {
namespace {

std::string format_word(FramePixels pixels) {
  switch (pixels) {
    case FramePixels::kRgb8:
      return "rgb24";
    case FramePixels::kRgba8:
      return "rgba";
    case FramePixels::kRgba16:
      return "rgba64le";
    case FramePixels::kRgbFloat:
      return "gbrpf32le";
    case FramePixels::kGreyFloat:
      return "grayf32le";
  }
  return "";
}

std::vector<std::string> command(const std::filesystem::path& path, FramePixels pixels) {
  // One thread and the slow, exact conversion give the same pixels on every machine. A wrong checksum ends the reading.
  std::vector<std::string> arguments = {
      "ffmpeg",   "-v", "error",        "-nostdin", "-xerror", "-err_detect", "crccheck+bitstream+buffer",
      "-threads", "1",  "-noautorotate"};
  const std::vector<std::string> input = picture_input_options();
  arguments.insert(arguments.end(), input.begin(), input.end());
  for (const std::string& argument :
       {std::string("-i"), "file:" + path.string(), std::string("-map"), std::string("0:v:0"), std::string("-fps_mode"),
        std::string("passthrough"), std::string("-sws_flags"),
        std::string("bicubic+accurate_rnd+full_chroma_int+full_chroma_inp+bitexact"), std::string("-f"),
        std::string("rawvideo"), std::string("-pix_fmt"), format_word(pixels), std::string("pipe:1")}) {
    arguments.push_back(argument);
  }
  return arguments;
}

}  // namespace

std::size_t frame_bytes(ImageSize size, FramePixels pixels) {
  const std::size_t count = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  switch (pixels) {
    case FramePixels::kRgb8:
      return count * 3;
    case FramePixels::kRgba8:
      return count * 4;
    case FramePixels::kRgba16:
      return count * 8;
    case FramePixels::kRgbFloat:
      return count * 12;
    case FramePixels::kGreyFloat:
      return count * 4;
  }
  return 0;
}

struct FrameReader::Implementation {
  std::filesystem::path path;
  std::size_t bytes = 0;
  Program program;
  bool ended = false;
};

FrameReader::FrameReader(const std::filesystem::path& path, ImageSize size, FramePixels pixels)
    : implementation_(new Implementation{.path = path,
                                         .bytes = frame_bytes(size, pixels),
                                         .program = Program(command(path, pixels), ProgramOutput::kStreamed)}) {}

FrameReader::~FrameReader() = default;

bool FrameReader::next(std::span<std::uint8_t> frame) {
  Implementation& self = *implementation_;
  if (self.ended) return false;
  const std::size_t received = self.program.receive(frame.first(self.bytes));
  if (received == self.bytes) return true;
  self.ended = true;
  const ProgramResult end = self.program.finish();
  if (received == 0 && end.exit_code == 0 && end.errors.empty()) return false;
  std::string words = end.errors.substr(0, end.errors.find('\n'));
  if (words.starts_with('[')) words.erase(0, std::min(words.find("] ") + 2, words.size()));
  throw ImageUnreadable("cannot read " + self.path.string() + ": cut short or damaged (" +
                        (words.empty() ? "it ends within a frame" : words) + ")");
}

}  // namespace thinwall
