#include "renderer/picture/FilmPass.hpp"

#include <cstddef>

#include "renderer/picture/FrameUniforms.hpp"
#include "renderer/picture/ShaderProgram.hpp"

namespace thinwall {

FilmPass::FilmPass()
    : programs_{build_program("film.vert", "film.frag"), build_program("film.vert", "film_endoscope.frag")},
      triangles_(sizeof(FilmVertex), {{0, 3, offsetof(FilmVertex, position)},
                                      {1, 3, offsetof(FilmVertex, normal)},
                                      {2, 3, offsetof(FilmVertex, rest)},
                                      {3, 4, offsetof(FilmVertex, inward)},
                                      {4, 1, offsetof(FilmVertex, lift)}}) {}

void FilmPass::draw(std::span<const BodyFilm> films, Surroundings surroundings) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(programs_[static_cast<std::size_t>(surroundings)].name());
  for (const auto& [film, look] : films) {
    triangles_.upload(std::span<const FilmVertex>(film.vertices), film.corners);
    glUniform4f(0, static_cast<float>(linear_from_srgb(look.color[0])),
                static_cast<float>(linear_from_srgb(look.color[1])),
                static_cast<float>(linear_from_srgb(look.color[2])), static_cast<float>(1 / look.clarity));
    triangles_.draw();
  }
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

}  // namespace thinwall
