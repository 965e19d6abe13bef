#pragma once

#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/SceneMeshes.hpp"

namespace thinwall {

/// Where the scene keeps light off the floor: a small blurred map of the floor, on which the scene is laid along the
/// key light and straight down. On a plane this is cheaper and softer than the shadow map.
class FloorShade {
 public:
  FloorShade();

  /// Draws the map anew and binds it where floor.frag reads it; the Frame block must be bound.
  void draw(const SceneMeshes& meshes, Vector3 toward_light) const;

  /// Binds an empty map.
  void clear() const;

 private:
  void lay(const SceneMeshes& meshes, Vector3 along) const;
  void blur(const Texture& from, const Framebuffer& to, int across, int along) const;

  Texture fine_;  // before it is made smaller: a cell that is covered in part takes a part of the light
  Texture cover_;
  Texture blurred_;
  Framebuffer fine_frame_;
  Framebuffer cover_frame_;
  Framebuffer blurred_frame_;
  Program cover_program_;
  Program blur_program_;
  VertexArray no_vertices_;
};

}  // namespace thinwall
