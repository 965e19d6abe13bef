#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace thinwall {

/// A box of an MP4 file (ISO/IEC 14496-12): where its content lies.
struct Mp4Box {
  std::string type;
  std::uint64_t begin = 0;  // byte of the content
  std::uint64_t end = 0;    // byte behind the content
};

/// The number in bytes, the first of which counts most.
std::uint64_t big_endian(std::string_view bytes);

/// An MP4 file, of which boxes are found and single bytes changed. What goes wrong is a PictureFailure.
class Mp4File {
 public:
  /// `mode`: std::ios::in, with std::ios::out where it is to be changed.
  Mp4File(const std::filesystem::path& path, std::ios::openmode mode);

  std::uint64_t size() const { return size_; }
  std::string read(std::uint64_t place, std::size_t count);
  void write(std::uint64_t place, char byte);

  /// The first box of a type between two places; nothing when there is none.
  std::optional<Mp4Box> find(std::string_view type, std::uint64_t begin, std::uint64_t end);

  /// The first box of a type within the first of another within ..., as `path` names them.
  std::optional<Mp4Box> find_within(const Mp4Box& box, const std::vector<std::string_view>& path);

  std::vector<Mp4Box> tracks();

  /// Four letters: `vide` of a video, `sbtl` of captions; none where the track does not tell.
  std::string kind_of(const Mp4Box& track);

  [[noreturn]] void fail(const std::string& what) const;

 private:
  Mp4Box box_at(std::uint64_t place, std::uint64_t limit);

  std::fstream file_;
  std::string name_;
  std::uint64_t size_ = 0;
};

}  // namespace thinwall
