#pragma once

#include <string>
#include <vector>

#include "renderer/camera/Shot.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// What the pixels of two states show, as a picture to be looked at, judged by the rule of its kind.
struct StateLayer {
  std::string name;     // "depth", "normals", "parts", "flow"
  std::string verdict;  // "largest difference 0.8 mm, ..."
  Image golden;         // of flow: how far the golden's matter has moved
  Image today;          // none of flow
};

/// Ground truth of the golden's state and of today's, both seen by `shot`: depth, normals, parts, and where the matter
/// of the golden's pixels has gone. Needs no graphics.
std::vector<StateLayer> state_layers(const Snapshot& golden, const Snapshot& today, const Shot& shot, ImageSize size);

}  // namespace thinwall
