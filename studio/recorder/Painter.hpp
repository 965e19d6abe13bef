#pragma once

#include <functional>
#include <memory>
#include <string>

#include "renderer/device/DeviceChoice.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/picture/View.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Draws snapshots. Made and used by one thread, because a GL context belongs to a thread.
class Painter {
 public:
  virtual ~Painter() = default;
  virtual Image paint(const Snapshot& snapshot) = 0;
  /// What draws, as it names itself.
  virtual std::string driver() const = 0;
};

/// Makes a painter for pictures of a size. Throws PictureFailure when there is no device for it.
using PainterFactory = std::function<std::unique_ptr<Painter>(ImageSize)>;

/// Painters that draw with the renderer.
PainterFactory renderer_painters(const DeviceChoice& device, Tier tier, const ViewDefinition& view);

}  // namespace thinwall
