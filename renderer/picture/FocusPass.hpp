#pragma once

#include "renderer/camera/Camera.hpp"
#include "renderer/picture/PictureTarget.hpp"

namespace thinwall {

/// Blurs what the camera's lens does not have in focus: a point at depth z is seen as a disc of the diameter
/// aperture |1/focus - 1/z| over the pixel's tangent (thin lens). Discs are gathered at half the size, so what is sharp
/// keeps its border, and what is blurred does not spread over it.
class FocusPass {
 public:
  FocusPass();

  /// `pinhole`: the camera that the target's colours were drawn by.
  void draw(const PictureTarget& target, const Camera& pinhole) const;

 private:
  Program shrink_;
  Program gather_;
  Program blend_;
  VertexArray no_vertices_;
};

}  // namespace thinwall
