#pragma once

#include <string>
#include <vector>

#include "renderer/annotation/Annotation.hpp"
#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Notices labels whose point lies beside all pictures in which they were to be shown, and which therefore are not
/// drawn.
class UnseenLabelNotes {
 public:
  /// In the order of the scenario.
  explicit UnseenLabelNotes(const std::vector<LabelDefinition>& labels);

  /// Of pictures that are drawn, in order of time.
  void see(const Snapshot& snapshot, const Shot& shot, ImageSize size);

  /// A sentence for each label that was asked for in pictures and came into none of them.
  std::vector<std::string> notes() const;

 private:
  struct Label {
    LabelDefinition definition;
    bool was_asked_for = false;
    bool was_seen = false;
  };
  std::vector<Label> labels_;
};

}  // namespace thinwall
