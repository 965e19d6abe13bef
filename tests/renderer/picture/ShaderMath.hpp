#pragma once

#include <array>
#include <string>
#include <vector>

#include "renderer/device/OffscreenContext.hpp"
#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/ShaderProgram.hpp"

namespace thinwall::test {

/// Runs functions of the shader files on the device. The context must be current.
/// `includes`: files to include; `body`: GLSL that sets `vec4 result` from `int index`, 0 to `count` - 1.
inline std::vector<std::array<float, 4>> run_shader(const std::vector<std::string>& includes, const std::string& body,
                                                    int count) {
  std::string text = "#version 450 core\n";
  for (const std::string& file : includes) text += "#include \"" + file + "\"\n";
  text += "layout(location = 0) out vec4 result;\nvoid main() {\n  int index = int(gl_FragCoord.x);\n" + body + "\n}\n";
  const Shader vertex = compile_shader(GL_VERTEX_SHADER, "whole_picture.vert",
                                       "#version 450 core\nvoid main() {\n"
                                       "  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : "
                                       "-1.0, 0.0, 1.0);\n}\n");
  const Shader fragment = compile_shader(GL_FRAGMENT_SHADER, "under_test.frag", text);
  const Program program(glCreateProgram());
  glAttachShader(program.name(), vertex.name());
  glAttachShader(program.name(), fragment.name());
  glLinkProgram(program.name());
  const Texture texture = create_texture(GL_RGBA32F, count, 1, GL_NEAREST);
  const Framebuffer frame = create_framebuffer();
  glNamedFramebufferTexture(frame.name(), GL_COLOR_ATTACHMENT0, texture.name(), 0);
  require_complete(frame, "a frame of results");
  const VertexArray no_vertices = create_vertex_array();
  glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
  glViewport(0, 0, count, 1);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(program.name());
  glBindVertexArray(no_vertices.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<std::array<float, 4>> results(static_cast<std::size_t>(count));
  glReadPixels(0, 0, count, 1, GL_RGBA, GL_FLOAT, results.data());
  require_no_gl_error("running a shader");
  return results;
}

}  // namespace thinwall::test
