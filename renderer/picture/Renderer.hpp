#pragma once

#include <memory>
#include <string>
#include <vector>

#include "renderer/camera/View.hpp"
#include "renderer/device/DeviceChoice.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// What a pass of a picture took.
struct PassTime {
  std::string pass;
  double wall_seconds = 0;
  double processor_seconds = 0;  // of all threads of the process
};

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

  /// The same scene in the same light, seen by `camera` instead of the view's.
  Image draw(const Snapshot& snapshot, const ViewDefinition& view, const CameraDefinition& camera);

  /// The same picture, with the driver made to end each pass before the next begins, so that each can be timed. Appends
  /// to `times`.
  Image draw_timed(const Snapshot& snapshot, const ViewDefinition& view, std::vector<PassTime>& times);
  Image draw_timed(const Snapshot& snapshot, const ViewDefinition& view, const CameraDefinition& camera,
                   std::vector<PassTime>& times);

  /// Vendor, renderer and version as the driver names itself, one line.
  std::string driver() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace thinwall
