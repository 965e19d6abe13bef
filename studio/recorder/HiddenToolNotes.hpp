#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// Notices tools that touch where the camera never sees it.
class HiddenToolNotes {
 public:
  /// Of pictures that are drawn, in order of time.
  void see(const Snapshot& snapshot, const Shot& shot, ImageSize size);

  /// A sentence for each tool that a wall hid in all pictures in which it touched, with a side that shows it, or that
  /// touched beside all of them, with where it did.
  std::vector<std::string> notes() const;

 private:
  static constexpr std::size_t kSides = 8;
  struct Touching {
    double since = 0;  // seconds
    Vector3 place;     // metres, of then
    bool was_in_picture = false;
    bool was_seen = false;
    std::array<bool, kSides> is_free = {true, true, true, true, true, true, true, true};
  };
  static Double3 facing(std::size_t side);
  std::map<std::string, Touching> by_tool_;
};

}  // namespace thinwall
