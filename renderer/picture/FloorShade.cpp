#include "renderer/picture/FloorShade.hpp"

#include <array>

#include "renderer/picture/ShaderProgram.hpp"

namespace thinwall {
namespace {

constexpr int kResolution = 96;  // the blur leaves nothing finer
constexpr int kFine = 2 * kResolution;

Framebuffer frame_of(const Texture& texture) {
  Framebuffer frame = create_framebuffer();
  glNamedFramebufferTexture(frame.name(), GL_COLOR_ATTACHMENT0, texture.name(), 0);
  require_complete(frame, "the map of the floor's shade");
  return frame;
}

void empty(const Framebuffer& frame) {
  const float none[4] = {0, 0, 0, 0};
  glClearNamedFramebufferfv(frame.name(), GL_COLOR, 0, none);
}

}  // namespace

FloorShade::FloorShade()
    : fine_(create_texture(GL_RG8, kFine, kFine, GL_LINEAR)),
      cover_(create_texture(GL_RG8, kResolution, kResolution, GL_LINEAR)),
      blurred_(create_texture(GL_RG8, kResolution, kResolution, GL_LINEAR)),
      fine_frame_(frame_of(fine_)),
      cover_frame_(frame_of(cover_)),
      blurred_frame_(frame_of(blurred_)),
      cover_program_(build_program("cover.vert", "cover.frag")),
      blur_program_(build_program("blur.vert", "blur.frag")),
      no_vertices_(create_vertex_array()) {}

void FloorShade::draw(const SceneMeshes& meshes, Vector3 toward_light) const {
  glViewport(0, 0, kFine, kFine);
  glDisable(GL_DEPTH_TEST);
  glBindFramebuffer(GL_FRAMEBUFFER, fine_frame_.name());
  empty(fine_frame_);
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);
  glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
  lay(meshes, {0, 0, 1});
  glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
  // A light at the horizon or below throws no shadow on the floor.
  if (toward_light.z > 0.05) lay(meshes, toward_light);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_BLEND);
  glBlitNamedFramebuffer(fine_frame_.name(), cover_frame_.name(), 0, 0, kFine, kFine, 0, 0, kResolution, kResolution,
                         GL_COLOR_BUFFER_BIT, GL_LINEAR);
  glViewport(0, 0, kResolution, kResolution);
  blur(cover_, blurred_frame_, 1, 0);
  blur(blurred_, cover_frame_, 0, 1);
  glBindTextureUnit(1, cover_.name());
}

void FloorShade::lay(const SceneMeshes& meshes, Vector3 along) const {
  glProgramUniform3f(cover_program_.name(), 0, static_cast<float>(along.x), static_cast<float>(along.y),
                     static_cast<float>(along.z));
  glUseProgram(cover_program_.name());
  // What lies lowest hides the rest. Where on the floor it stands counts here, not in which units.
  std::array<float, 16> laid{};
  laid[0] = laid[5] = laid[15] = 1;
  laid[8] = static_cast<float>(-along.x / along.z);
  laid[9] = static_cast<float>(-along.y / along.z);
  meshes.draw_nearest(GL_FRONT, laid);
}

void FloorShade::clear() const {
  empty(cover_frame_);
  glBindTextureUnit(1, cover_.name());
}

void FloorShade::blur(const Texture& from, const Framebuffer& to, int across, int along) const {
  glBindFramebuffer(GL_FRAMEBUFFER, to.name());
  glProgramUniform2i(blur_program_.name(), 0, across, along);
  glBindTextureUnit(0, from.name());
  glUseProgram(blur_program_.name());
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace thinwall
