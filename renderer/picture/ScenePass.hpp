#pragma once

#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/PictureTarget.hpp"
#include "renderer/picture/SceneMeshes.hpp"

namespace thinwall {

/// Draws tissue, tools and floor, one function after the other; the Frame block and the maps must be bound.
class ScenePass {
 public:
  ScenePass();

  /// What is seen of the tissue, as geometry.
  void draw_surface(const SceneMeshes& meshes, const PictureTarget& target) const;

  /// Its colours.
  void shade_tissue(const SceneMeshes& meshes, const PictureTarget& target) const;

  /// Tools and floor.
  void draw_surroundings(const SceneMeshes& meshes) const;

 private:
  void draw_screen() const;

  Program surface_;
  Program tissue_;
  Program metal_;
  Program floor_;
  VertexArray no_vertices_;
  Buffer look_;  // of the part that is shaded
};

}  // namespace thinwall
