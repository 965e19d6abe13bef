#pragma once

#include <memory>
#include <string>

#include "renderer/device/DeviceChoice.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/picture/View.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Draws snapshots without a window. Owns its GL context; use it from one thread at a time.
class Renderer {
 public:
  /// Throws PictureFailure when no device serves, with the reason for each.
  Renderer(const DeviceChoice& device, ImageSize size, Tier tier);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// The picture of a snapshot: a pure function of the arguments, size and tier, whatever was drawn before.
  Image draw(const Snapshot& snapshot, const ViewDefinition& view);

  /// Vendor, renderer and version as the driver names itself, one line.
  std::string driver() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace thinwall
