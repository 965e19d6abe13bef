#include "renderer/picture/MeshLinePass.hpp"

#include <cstddef>

#include "renderer/picture/ShaderProgram.hpp"

namespace thinwall {

MeshLinePass::MeshLinePass()
    : program_(build_program("mesh.vert", "mesh.frag")), array_(create_vertex_array()), lines_(create_buffer()) {
  glVertexArrayVertexBuffer(array_.name(), 0, lines_.name(), 0, sizeof(MeshLine));
  glVertexArrayBindingDivisor(array_.name(), 0, 1);
  const GLuint offsets[] = {offsetof(MeshLine, start), offsetof(MeshLine, end), offsetof(MeshLine, is_cut)};
  const GLint components[] = {3, 3, 1};
  for (GLuint location = 0; location < 3; ++location) {
    glEnableVertexArrayAttrib(array_.name(), location);
    glVertexArrayAttribFormat(array_.name(), location, components[location], GL_FLOAT, GL_FALSE, offsets[location]);
    glVertexArrayAttribBinding(array_.name(), location, 0);
  }
}

void MeshLinePass::draw(std::span<const MeshLine> lines) const {
  if (lines.empty()) return;
  glNamedBufferData(lines_.name(), static_cast<GLsizeiptr>(lines.size_bytes()), lines.data(), GL_STREAM_DRAW);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(program_.name());
  glBindVertexArray(array_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(lines.size()));
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

}  // namespace thinwall
