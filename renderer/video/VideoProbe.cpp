#include "renderer/video/VideoProbe.hpp"

#include "renderer/video/Mp4File.hpp"

namespace thinwall {
namespace {

/// The content of a box that a video track has; throws where it has none.
Mp4Box box_of(Mp4File& file, const Mp4Box& track, const std::vector<std::string_view>& path) {
  const auto box = file.find_within(track, path);
  if (!box) file.fail("has a video track without `" + std::string(path.back()) + "`");
  return *box;
}

/// A whole number of 4 bytes.
std::uint64_t number_at(Mp4File& file, std::uint64_t place) {
  return big_endian(file.read(place, 4));
}

/// Headers of version 1 hold times of 8 bytes instead of 4.
bool has_long_times(Mp4File& file, const Mp4Box& header) {
  return file.read(header.begin, 1)[0] == 1;
}

ImageSize size_of(Mp4File& file, const Mp4Box& track) {
  const Mp4Box header = box_of(file, track, {"tkhd"});
  const std::uint64_t place = header.begin + (has_long_times(file, header) ? 88 : 76);
  // With 16 bits behind the point.
  return {static_cast<int>(number_at(file, place) >> 16), static_cast<int>(number_at(file, place + 4) >> 16)};
}

/// Seconds.
double duration_of(Mp4File& file, const Mp4Box& track) {
  const Mp4Box header = box_of(file, track, {"mdia", "mdhd"});
  const bool is_long = has_long_times(file, header);
  const std::uint64_t place = header.begin + (is_long ? 20 : 12);
  const std::uint64_t ticks_per_second = number_at(file, place);
  if (ticks_per_second == 0) file.fail("has a video track without unit of time");
  const std::uint64_t ticks = big_endian(file.read(place + 4, is_long ? 8 : 4));
  return static_cast<double>(ticks) / static_cast<double>(ticks_per_second);
}

std::int64_t frames_of(Mp4File& file, const Mp4Box& track) {
  const Mp4Box sizes = box_of(file, track, {"mdia", "minf", "stbl", "stsz"});
  return static_cast<std::int64_t>(number_at(file, sizes.begin + 8));
}

}  // namespace

VideoProbe probe_video(const std::filesystem::path& path) {
  Mp4File file(path, std::ios::in);
  // The last box of a file that starts fast: it is not found where it is cut short.
  if (!file.find("mdat", 0, file.size())) file.fail("holds no pictures");
  for (const Mp4Box& track : file.tracks()) {
    if (file.kind_of(track) != "vide") continue;
    return {.size = size_of(file, track), .frames = frames_of(file, track), .duration = duration_of(file, track)};
  }
  file.fail("has no video track");
}

}  // namespace thinwall
