#pragma once

#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/SceneMeshes.hpp"

namespace thinwall {

/// Draws tools, tissue and floor to the current frame; the Frame block and the maps must be bound.
class ScenePass {
 public:
  ScenePass();
  void draw(const SceneMeshes& meshes) const;

 private:
  void draw_tissue(const SceneMeshes& meshes) const;

  Program metal_;
  Program tissue_;
  Program floor_;
  VertexArray no_vertices_;
};

}  // namespace thinwall
