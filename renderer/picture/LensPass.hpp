#pragma once

#include "renderer/camera/Camera.hpp"
#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/PictureTarget.hpp"

namespace thinwall {

/// Bends the pinhole's picture into the one that the camera's lens gives.
class LensPass {
 public:
  LensPass();

  /// From the target's colours, drawn by `pinhole`, to those of its lens frame.
  void draw(const PictureTarget& target, const Camera& camera, const Camera& pinhole) const;

 private:
  Program program_;
  VertexArray no_vertices_;
};

}  // namespace thinwall
