#include "renderer/picture/OutlinePass.hpp"

#include <cstddef>

#include "renderer/picture/ShaderProgram.hpp"

namespace thinwall {
namespace {

/// The bit of the stencil that no part's number uses, see ScenePass: pixels that are smoothed.
constexpr GLuint kSmoothed = 0x80;

}  // namespace

OutlinePass::OutlinePass()
    : program_(build_program("outline.vert", "outline.frag")),
      blend_(build_program("outline.vert", "outline_blend.frag")),
      array_(create_vertex_array()),
      segments_(create_buffer()) {
  glVertexArrayVertexBuffer(array_.name(), 0, segments_.name(), 0, sizeof(OutlineSegment));
  glVertexArrayBindingDivisor(array_.name(), 0, 1);
  const GLuint offsets[] = {offsetof(OutlineSegment, start), offsetof(OutlineSegment, end)};
  for (GLuint location = 0; location < 2; ++location) {
    glEnableVertexArrayAttrib(array_.name(), location);
    glVertexArrayAttribFormat(array_.name(), location, 3, GL_FLOAT, GL_FALSE, offsets[location]);
    glVertexArrayAttribBinding(array_.name(), location, 0);
  }
}

void OutlinePass::draw_lines(const Program& program, std::size_t count) const {
  glUseProgram(program.name());
  glBindVertexArray(array_.name());
  glDrawArraysInstanced(GL_LINES, 0, 2, static_cast<GLsizei>(count));
}

void OutlinePass::draw(std::span<const OutlineSegment> outline, const PictureTarget& target) const {
  if (outline.empty()) return;
  glNamedBufferData(segments_.name(), static_cast<GLsizeiptr>(outline.size_bytes()), outline.data(), GL_STREAM_DRAW);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  // What the neighbours take is drawn twice, first beside the colours: to copy these the processor would have to wait
  // for the driver's threads, and they for it. Where a round wall folds over within a pixel, several lines run through
  // it, and each would take its part.
  target.begin_smoothing();
  glEnable(GL_STENCIL_TEST);
  glStencilMask(kSmoothed);
  glStencilFunc(GL_NOTEQUAL, kSmoothed, kSmoothed);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  draw_lines(program_, outline.size());
  target.begin_smoothed();
  glStencilFunc(GL_EQUAL, kSmoothed, kSmoothed);
  glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  draw_lines(blend_, outline.size());
  glDisable(GL_BLEND);
  glStencilMask(0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glDisable(GL_STENCIL_TEST);
  glDepthMask(GL_TRUE);
}

}  // namespace thinwall
