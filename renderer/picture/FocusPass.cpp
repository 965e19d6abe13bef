#include "renderer/picture/FocusPass.hpp"

#include "renderer/picture/ShaderProgram.hpp"

namespace thinwall {

FocusPass::FocusPass()
    : shrink_(build_program("blur.vert", "focus_shrink.frag")),
      gather_(build_program("blur.vert", "focus_gather.frag")),
      blend_(build_program("blur.vert", "focus_blend.frag")),
      no_vertices_(create_vertex_array()) {}

void FocusPass::draw(const PictureTarget& target, const Camera& pinhole) const {
  const double pixels = 0.5 * target.size().height / pinhole.tangent_y;  // of a tangent of 1
  const double span = pinhole.farthest - pinhole.nearest;
  const auto use = [&](const Program& program) {
    glUseProgram(program.name());
    // Depth on the screen is a - b / z.
    glUniform4f(0, static_cast<float>(pinhole.aperture * pixels), static_cast<float>(1 / pinhole.focus),
                static_cast<float>((pinhole.farthest + pinhole.nearest) / span),
                static_cast<float>(2 * pinhole.farthest * pinhole.nearest / span));
    glDrawArrays(GL_TRIANGLES, 0, 3);
  };
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(no_vertices_.name());
  target.begin_blurred(0);
  use(shrink_);
  target.begin_blurred(1);
  use(gather_);
  target.begin_focused();
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  use(blend_);
  glDisable(GL_BLEND);
}

}  // namespace thinwall
