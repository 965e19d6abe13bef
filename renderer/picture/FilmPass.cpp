#include "renderer/picture/FilmPass.hpp"

#include <cstddef>

#include "renderer/picture/FluidUniforms.hpp"
#include "renderer/picture/ShaderProgram.hpp"
#include "renderer/picture/TwoSourceBlending.hpp"

namespace thinwall {

FilmPass::FilmPass()
    : programs_{build_program("film.vert", "film.frag"), build_program("film.vert", "film_endoscope.frag")},
      triangles_(sizeof(FilmVertex), {{0, 3, offsetof(FilmVertex, position)},
                                      {1, 3, offsetof(FilmVertex, normal)},
                                      {2, 3, offsetof(FilmVertex, rest)},
                                      {3, 4, offsetof(FilmVertex, inward)},
                                      {4, 2, offsetof(FilmVertex, lift)},
                                      {5, 3, offsetof(FilmVertex, slope)}}) {}

void FilmPass::draw(std::span<const BodyFilm> films, Surroundings surroundings) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_STENCIL_TEST);
  glStencilMask(0);
  const TwoSourceBlending blending;
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  // Some drivers heed what a shader tells even where this is disabled.
  glEnable(GL_CLIP_DISTANCE0);
  glUseProgram(programs_[static_cast<std::size_t>(surroundings)].name());
  for (const auto& [film, look, is_falling] : films) {
    // A film on a wall is drawn a little in front of it, but not in front of the tools. What faces away is left out:
    // the far side of a drop, and a cut's face where it would show along the edge that hides it.
    glStencilFunc(is_falling ? GL_ALWAYS : GL_NOTEQUAL, 0, 0xff);
    triangles_.upload(std::span<const FilmVertex>(film.vertices), film.corners);
    set_fluid_look(look);
    glUniform1i(2, is_falling && surroundings == Surroundings::kStudio ? 1 : 0);
    triangles_.draw();
  }
  glDisable(GL_CLIP_DISTANCE0);
  glDisable(GL_CULL_FACE);
  glStencilMask(0xff);
  glDisable(GL_STENCIL_TEST);
  glDepthMask(GL_TRUE);
}

}  // namespace thinwall
