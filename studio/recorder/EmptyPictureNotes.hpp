#pragma once

#include <string>
#include <vector>

#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Notices a camera that looks past all bodies, or stands so far off that they are specks.
class EmptyPictureNotes {
 public:
  /// Of pictures that are drawn, in order of time.
  void see(const Snapshot& snapshot, const Shot& shot, ImageSize size);

  /// A sentence where none of the pictures showed a body.
  std::vector<std::string> notes() const;

 private:
  bool has_pictures_ = false;
  bool was_seen_ = false;
  bool is_speck_ = false;  // in one of the pictures: they have a body in them, but a tiny one
};

}  // namespace thinwall
