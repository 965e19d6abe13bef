#include "renderer/video/Mp4File.hpp"

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

Mp4File::Mp4File(const std::filesystem::path& path, std::ios::openmode mode)
    : file_(path, mode | std::ios::binary), name_(path.string()) {
  if (!file_) fail("cannot be opened");
  file_.seekg(0, std::ios::end);
  size_ = static_cast<std::uint64_t>(file_.tellg());
}

std::string Mp4File::read(std::uint64_t place, std::size_t count) {
  std::string bytes(count, '\0');
  file_.seekg(static_cast<std::streamoff>(place));
  file_.read(bytes.data(), static_cast<std::streamsize>(count));
  if (!file_) fail("ends inside a box");
  return bytes;
}

void Mp4File::write(std::uint64_t place, char byte) {
  file_.seekp(static_cast<std::streamoff>(place));
  file_.put(byte);
  if (!file_.flush()) fail("cannot be changed");
}

Mp4Box Mp4File::box_at(std::uint64_t place, std::uint64_t limit) {
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

std::optional<Mp4Box> Mp4File::find(std::string_view type, std::uint64_t begin, std::uint64_t end) {
  while (begin + 8 <= end) {
    const Mp4Box box = box_at(begin, end);
    if (box.type == type) return box;
    begin = box.end;
  }
  return std::nullopt;
}

std::optional<Mp4Box> Mp4File::find_within(const Mp4Box& box, const std::vector<std::string_view>& path) {
  std::optional<Mp4Box> found = box;
  for (const std::string_view type : path) {
    if (found) found = find(type, found->begin, found->end);
  }
  return found;
}

std::vector<Mp4Box> Mp4File::tracks() {
  const auto movie = find("moov", 0, size_);
  if (!movie) fail("has no list of tracks");
  std::vector<Mp4Box> tracks;
  for (auto track = find("trak", movie->begin, movie->end); track; track = find("trak", track->end, movie->end)) {
    tracks.push_back(*track);
  }
  return tracks;
}

std::string Mp4File::kind_of(const Mp4Box& track) {
  const auto handler = find_within(track, {"mdia", "hdlr"});
  return handler ? read(handler->begin + 8, 4) : "";
}

void Mp4File::fail(const std::string& what) const {
  throw PictureFailure("the video " + name_ + " " + what);
}

}  // namespace thinwall
