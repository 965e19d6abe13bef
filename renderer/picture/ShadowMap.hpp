#pragma once

#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/SceneMeshes.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// How far the key light reaches: depth seen from it.
class ShadowMap {
 public:
  /// `resolution` in texels on a side.
  explicit ShadowMap(int resolution);

  /// It has to be drawn anew then.
  void resize(int resolution);

  /// Draws the map anew, of tissue and, `with_tools`, of tools.
  void draw(const SceneMeshes& meshes, const Matrix4& light_matrix, bool with_tools) const;

  /// Makes a map without shadows.
  void clear() const;

  /// Binds the map where shadow.glsl reads it.
  void bind() const;

 private:
  int resolution_ = 0;
  Texture depth_;
  Framebuffer frame_;
  Program program_;
};

}  // namespace thinwall
