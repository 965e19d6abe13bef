#include "renderer/picture/ToolShade.hpp"

namespace thinwall {
namespace {

constexpr int kResolution = ToolCover::kResolution;

}  // namespace

ToolShade::ToolShade()
    : taken_(create_texture(GL_RGBA8, kResolution, kResolution, GL_LINEAR)),
      depths_(create_texture(GL_R32F, kResolution, kResolution, GL_LINEAR)) {}

void ToolShade::lay(const SceneMeshes& meshes, const FrameUniforms& frame) {
  cover_.lay(meshes.tool_vertices(), meshes.tool_corners(), frame.shadow_matrix);
}

void ToolShade::upload() {
  glTextureSubImage2D(taken_.name(), 0, 0, 0, kResolution, kResolution, GL_RGBA, GL_UNSIGNED_BYTE,
                      cover_.taken().data());
  glTextureSubImage2D(depths_.name(), 0, 0, 0, kResolution, kResolution, GL_RED, GL_FLOAT, cover_.depths().data());
  is_empty_ = false;
  bind();
}

void ToolShade::clear() {
  if (!is_empty_) {
    glClearTexImage(taken_.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glClearTexImage(depths_.name(), 0, GL_RED, GL_FLOAT, nullptr);
  }
  is_empty_ = true;
  bind();
}

void ToolShade::bind() const {
  glBindTextureUnit(8, taken_.name());
  glBindTextureUnit(9, depths_.name());
}

}  // namespace thinwall
