#pragma once

#include <span>

#include "renderer/picture/GlObjects.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// An edge of a wall's triangles.
struct MeshLine {
  Float3 start{};    // metres
  Float3 end{};      // metres
  float is_cut = 0;  // 1 at a cut, else 0
};

/// Draws lines over what is seen of the walls; the Frame block and the frame of colours must be bound.
class MeshLinePass {
 public:
  MeshLinePass();
  void draw(std::span<const MeshLine> lines) const;

 private:
  Program program_;
  VertexArray array_;
  Buffer lines_;
};

}  // namespace thinwall
