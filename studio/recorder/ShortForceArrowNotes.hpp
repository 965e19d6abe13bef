#pragma once

#include <string>
#include <vector>

#include "renderer/annotation/Annotation.hpp"
#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Notices force arrows that the forces at their tools make too short to be drawn in all pictures.
class ShortForceArrowNotes {
 public:
  /// In the order of the scenario.
  explicit ShortForceArrowNotes(const std::vector<ForceArrowDefinition>& arrows);

  /// Of pictures that are drawn, in order of time.
  void see(const Snapshot& snapshot, const Shot& shot, ImageSize size);

  /// A sentence for each arrow whose tool is seen while it feels a force, and that is in no picture.
  std::vector<std::string> notes() const;

 private:
  struct Arrow {
    ForceArrowDefinition definition;
    double largest = 0;  // newton, of the forces for which it was too short
    bool was_seen = false;
  };
  std::vector<Arrow> arrows_;
};

}  // namespace thinwall
