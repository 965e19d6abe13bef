#include "renderer/picture/GlObjects.hpp"

#include <sstream>

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

std::string hexadecimal(GLenum value) {
  std::ostringstream text;
  text << "0x" << std::hex << value;
  return text.str();
}

std::string dimensions(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

Buffer create_buffer() {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  return Buffer(name);
}

VertexArray create_vertex_array() {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  return VertexArray(name);
}

Framebuffer create_framebuffer() {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  return Framebuffer(name);
}

Texture create_texture(GLenum format, int width, int height, GLint filter) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  Texture texture(name);
  glTextureStorage2D(name, 1, format, width, height);
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, filter);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, filter);
  glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  require_no_gl_error("the allocation of a texture of " + dimensions(width, height));
  return texture;
}

void require_complete(const Framebuffer& framebuffer, const std::string& what) {
  const GLenum status = glCheckNamedFramebufferStatus(framebuffer.name(), GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw PictureFailure("the driver cannot draw to " + what + " (framebuffer status " + hexadecimal(status) +
                         "); try --device software");
  }
}

void require_no_gl_error(const std::string& what) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  if (error == GL_OUT_OF_MEMORY) {
    throw PictureFailure("the driver has no memory for " + what + "; choose a smaller picture or tier");
  }
  throw PictureFailure("the driver reports GL error " + hexadecimal(error) + " in " + what + "; try --device software");
}

}  // namespace thinwall
