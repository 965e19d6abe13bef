#include "renderer/video/CaptionTrack.hpp"

#include "renderer/video/Mp4File.hpp"

namespace thinwall {

void disable_caption_tracks(const std::filesystem::path& path) {
  Mp4File file(path, std::ios::in | std::ios::out);
  for (const Mp4Box& track : file.tracks()) {
    if (file.kind_of(track) != "sbtl") continue;
    constexpr std::uint64_t kLastFlagByte = 3;  // behind the version and two more bytes of flags
    const auto header = file.find_within(track, {"tkhd"});
    if (!header) file.fail("has a track without header");
    const char flags = file.read(header->begin + kLastFlagByte, 1)[0];
    file.write(header->begin + kLastFlagByte, static_cast<char>(flags & ~1));
  }
}

}  // namespace thinwall
