#pragma once

#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/SceneMeshes.hpp"

namespace thinwall {

/// Where the scene keeps the light from all around off the floor: a small blurred map seen from above.
class FloorShade {
 public:
  FloorShade();

  /// Draws the map anew and binds it where floor.frag reads it; the Frame block must be bound.
  void draw(const SceneMeshes& meshes) const;

  /// Binds an empty map.
  void clear() const;

 private:
  void blur(const Texture& from, const Framebuffer& to, int across, int along) const;

  Texture cover_;
  Texture blurred_;
  Framebuffer cover_frame_;
  Framebuffer blurred_frame_;
  Program cover_program_;
  Program blur_program_;
  VertexArray no_vertices_;
};

}  // namespace thinwall
