#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "studio/recorder/Painter.hpp"

namespace thinwall {

/// Notices small pictures that lie over what a tool does.
class InsetNotes {
 public:
  /// Of pictures that are drawn, in order of time.
  void see(const Snapshot& snapshot, const Shot& shot, ImageSize size);

  /// A sentence for each tool whose tip was covered while it touched, with a corner that would have left all of them
  /// free.
  std::vector<std::string> notes() const;

 private:
  std::map<std::string, double> covered_since_;             // seconds, by tool
  std::array<bool, 4> is_free_ = {true, true, true, true};  // corners, as PictureCorner counts them
};

}  // namespace thinwall
