#pragma once

#include "renderer/picture/FrameUniforms.hpp"
#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/SceneMeshes.hpp"
#include "renderer/picture/ToolCover.hpp"

namespace thinwall {

/// The shadow of tools on what lies behind them, as soft as a large lamp leaves it.
class ToolShade {
 public:
  ToolShade();

  /// Makes the map anew, of the tools as the key light of a studio sees them, without graphics.
  void lay(const SceneMeshes& meshes, const FrameUniforms& frame);

  /// Binds it where shadow.glsl reads it.
  void upload();

  /// Binds an empty map.
  void clear();

 private:
  void bind() const;

  ToolCover cover_;
  Texture taken_;
  Texture depths_;
  bool is_empty_ = false;
};

}  // namespace thinwall
