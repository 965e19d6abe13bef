#pragma once

#include <array>
#include <span>

#include "renderer/picture/ScenePass.hpp"
#include "renderer/picture/TriangleBuffer.hpp"

namespace thinwall {

/// Draws the fluid that is seen in opened bodies, over a finished picture of tissue and tools: the Frame block, the
/// shadow map and the frame of colours must be bound, and the stencil must tell where tissue is.
class FluidPass {
 public:
  FluidPass();
  void draw(std::span<const BodyFluid> fluids, Surroundings surroundings);

 private:
  std::array<Program, 2> programs_;  // (surroundings)
  TriangleBuffer triangles_;
};

}  // namespace thinwall
