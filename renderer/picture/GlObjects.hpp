#pragma once

#include <epoxy/gl.h>

#include <string>
#include <utility>

namespace thinwall {

/// Owns the name of one GL object; movable, not copyable. The context must be current when it dies.
template <typename Traits>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(GLuint name) : name_(name) {}
  ~GlObject() { reset(); }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    if (this != &other) {
      reset();
      name_ = std::exchange(other.name_, 0);
    }
    return *this;
  }

  /// The name that GL functions take; 0 when empty.
  GLuint name() const { return name_; }

 private:
  void reset() noexcept {
    if (name_ != 0) Traits::destroy(name_);
    name_ = 0;
  }
  GLuint name_ = 0;
};

struct BufferTraits {
  static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct VertexArrayTraits {
  static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct TextureTraits {
  static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct FramebufferTraits {
  static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct ProgramTraits {
  static void destroy(GLuint name) { glDeleteProgram(name); }
};
struct ShaderTraits {
  static void destroy(GLuint name) { glDeleteShader(name); }
};

using Buffer = GlObject<BufferTraits>;
using VertexArray = GlObject<VertexArrayTraits>;
using Texture = GlObject<TextureTraits>;
using Framebuffer = GlObject<FramebufferTraits>;
using Program = GlObject<ProgramTraits>;
using Shader = GlObject<ShaderTraits>;

Buffer create_buffer();
VertexArray create_vertex_array();
Framebuffer create_framebuffer();

/// A texture of one level without filtering across its border. Throws PictureFailure when memory is short.
Texture create_texture(GLenum format, int width, int height, GLint filter);

/// Throws PictureFailure when `framebuffer` cannot be drawn to, naming it as `what`.
void require_complete(const Framebuffer& framebuffer, const std::string& what);

/// Throws PictureFailure when GL has recorded an error during `what`.
void require_no_gl_error(const std::string& what);

}  // namespace thinwall
