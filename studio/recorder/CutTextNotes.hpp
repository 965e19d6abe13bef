#pragma once

#include <string>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// Notices texts over pictures that are too long to be shown whole.
class CutTextNotes {
 public:
  /// A text of which a part is not shown.
  void see(const std::string& text);

  /// A sentence for each, in the order in which they came first, on pictures of `size`.
  std::vector<std::string> notes(ImageSize size) const;

 private:
  std::vector<std::string> texts_;
};

}  // namespace thinwall
