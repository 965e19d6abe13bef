#pragma once

#include <cstdint>
#include <span>

#include "renderer/picture/FloorCover.hpp"
#include "renderer/picture/FrameUniforms.hpp"
#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/SceneMeshes.hpp"

namespace thinwall {

/// Where the scene keeps light off the floor: a small blurred map of the floor, on which the scene is laid along the
/// key light and straight down. On a plane this is cheaper and softer than the shadow map.
class FloorShade {
 public:
  FloorShade();

  /// Makes the map anew, without graphics.
  void lay(const SceneMeshes& meshes, const FrameUniforms& frame, Vector3 toward_light);

  /// Binds it where floor.frag reads it.
  void upload() const;

  /// Binds an empty map.
  void clear() const;

 private:
  FloorCover cover_;
  std::span<const std::uint8_t> taken_;  // of the cover
  Texture map_;
};

}  // namespace thinwall
