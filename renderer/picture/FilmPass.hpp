#pragma once

#include <array>
#include <span>

#include "renderer/picture/ScenePass.hpp"
#include "renderer/picture/TriangleBuffer.hpp"

namespace thinwall {

/// Draws films of fluid over a finished picture of tissue and tools: the Frame block, the shadow map and the frame of
/// colours must be bound.
class FilmPass {
 public:
  FilmPass();
  void draw(std::span<const BodyFilm> films, Surroundings surroundings);

 private:
  std::array<Program, 2> programs_;  // (surroundings)
  TriangleBuffer triangles_;
};

}  // namespace thinwall
