#include "renderer/picture/ShadowMap.hpp"

#include <array>

#include "renderer/picture/ShaderProgram.hpp"

namespace thinwall {

ShadowMap::ShadowMap(int resolution) : frame_(create_framebuffer()), program_(build_program("depth.vert", "")) {
  resize(resolution);
}

void ShadowMap::resize(int resolution) {
  if (resolution == resolution_) return;
  resolution_ = resolution;
  depth_ = create_texture(GL_DEPTH_COMPONENT32F, resolution, resolution, GL_LINEAR);
  glTextureParameteri(depth_.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(depth_.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glNamedFramebufferTexture(frame_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
  glNamedFramebufferDrawBuffer(frame_.name(), GL_NONE);
  glNamedFramebufferReadBuffer(frame_.name(), GL_NONE);
  require_complete(frame_, "a shadow map");
}

void ShadowMap::draw(const SceneMeshes& meshes, const Matrix4& light_matrix, bool with_tools) const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glViewport(0, 0, resolution_, resolution_);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  clear();
  // Steep triangles span several depths within a texel of the map; they go back by as much, or they would shade
  // themselves.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2.0f, 2.0f);
  std::array<float, 16> matrix;
  for (std::size_t i = 0; i < 16; ++i) matrix[i] = static_cast<float>(light_matrix.values[i]);
  glProgramUniformMatrix4fv(program_.name(), 0, 1, GL_FALSE, matrix.data());
  glUseProgram(program_.name());
  meshes.draw_nearest(matrix, with_tools);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void ShadowMap::clear() const {
  glDepthMask(GL_TRUE);
  const float farthest = 1;
  glClearNamedFramebufferfv(frame_.name(), GL_DEPTH, 0, &farthest);
}

void ShadowMap::bind() const {
  glBindTextureUnit(0, depth_.name());
}

}  // namespace thinwall
