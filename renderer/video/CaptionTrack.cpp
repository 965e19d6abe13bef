#include "renderer/video/CaptionTrack.hpp"

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

/// A box of the file: where its content lies.
struct Mp4Box {
  std::string type;
  std::uint64_t begin = 0;  // byte of the content
  std::uint64_t end = 0;    // byte behind the content
};

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

class Mp4File {
 public:
  explicit Mp4File(const std::filesystem::path& path)
      : file_(path, std::ios::in | std::ios::out | std::ios::binary), name_(path.string()) {
    if (!file_) fail("cannot be opened");
    file_.seekg(0, std::ios::end);
    size_ = static_cast<std::uint64_t>(file_.tellg());
  }

  std::uint64_t size() const { return size_; }

  std::string read(std::uint64_t place, std::size_t count) {
    std::string bytes(count, '\0');
    file_.seekg(static_cast<std::streamoff>(place));
    file_.read(bytes.data(), static_cast<std::streamsize>(count));
    if (!file_) fail("ends inside a box");
    return bytes;
  }

  void write(std::uint64_t place, char byte) {
    file_.seekp(static_cast<std::streamoff>(place));
    file_.put(byte);
    if (!file_.flush()) fail("cannot be changed");
  }

  /// The box that begins at `place`, at most up to `limit`.
  Mp4Box box_at(std::uint64_t place, std::uint64_t limit) {
    std::uint64_t size = big_endian(read(place, 4));
    Mp4Box box{.type = read(place + 4, 4), .begin = place + 8};
    if (size == 1) {  // the size stands behind the type, in 8 bytes
      size = big_endian(read(place + 8, 8));
      box.begin += 8;
    }
    box.end = size == 0 ? limit : place + size;
    if (box.end < box.begin || box.end > limit) fail("has a box of impossible size");
    return box;
  }

  /// The first box of a type between two places; nothing when there is none.
  std::optional<Mp4Box> find(std::string_view type, std::uint64_t begin, std::uint64_t end) {
    while (begin + 8 <= end) {
      const Mp4Box box = box_at(begin, end);
      if (box.type == type) return box;
      begin = box.end;
    }
    return std::nullopt;
  }

  [[noreturn]] void fail(const std::string& what) const { throw PictureFailure("the video " + name_ + " " + what); }

 private:
  std::fstream file_;
  std::string name_;
  std::uint64_t size_ = 0;
};

bool is_caption_track(Mp4File& file, const Mp4Box& track) {
  const auto media = file.find("mdia", track.begin, track.end);
  const auto handler = media ? file.find("hdlr", media->begin, media->end) : std::nullopt;
  return handler && file.read(handler->begin + 8, 4) == "sbtl";
}

void disable(Mp4File& file, const Mp4Box& track) {
  constexpr std::uint64_t kLastFlagByte = 3;  // behind the version and two more bytes of flags
  const auto header = file.find("tkhd", track.begin, track.end);
  if (!header) file.fail("has a track without header");
  const char flags = file.read(header->begin + kLastFlagByte, 1)[0];
  file.write(header->begin + kLastFlagByte, static_cast<char>(flags & ~1));
}

}  // namespace

void disable_caption_tracks(const std::filesystem::path& path) {
  Mp4File file(path);
  const auto movie = file.find("moov", 0, file.size());
  if (!movie) file.fail("has no list of tracks");
  auto track = file.find("trak", movie->begin, movie->end);
  while (track) {
    if (is_caption_track(file, *track)) disable(file, *track);
    track = file.find("trak", track->end, movie->end);
  }
}

}  // namespace thinwall
