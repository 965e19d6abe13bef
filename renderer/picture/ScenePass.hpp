#pragma once

#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/PictureTarget.hpp"
#include "renderer/picture/SceneMeshes.hpp"

namespace thinwall {

/// Draws tissue, tools and floor; the Frame block and the maps must be bound.
class ScenePass {
 public:
  ScenePass();
  void draw(const SceneMeshes& meshes, const PictureTarget& target) const;

 private:
  void draw_surface(const SceneMeshes& meshes) const;
  void shade_tissue(const SceneMeshes& meshes) const;
  void draw_screen() const;

  Program surface_;
  Program tissue_;
  Program metal_;
  Program floor_;
  VertexArray no_vertices_;
};

}  // namespace thinwall
