#include "renderer/picture/ShaderProgram.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

constexpr const char* kFolder = "renderer/picture/shaders/";

/// A shader with its includes in place, and the files in the order of the numbers that #line gives them.
struct ExpandedShader {
  std::string text;
  std::vector<std::string> files;
};

std::string included_name(const std::string& line) {
  constexpr std::string_view kDirective = "#include \"";
  if (line.compare(0, kDirective.size(), kDirective) != 0) return {};
  return line.substr(kDirective.size(), line.find('"', kDirective.size()) - kDirective.size());
}

/// Appends `text`, the content of `file`. Each file is taken once; later includes of it are skipped.
void expand(const std::string& file, std::string_view text, ExpandedShader& shader) {
  const std::size_t number = shader.files.size();
  shader.files.push_back(file);
  std::istringstream lines{std::string(text)};
  int line_number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++line_number;
    const std::string name = included_name(line);
    if (name.empty()) {
      shader.text += line + '\n';
      continue;
    }
    if (std::find(shader.files.begin(), shader.files.end(), name) == shader.files.end()) {
      const std::string_view content = shader_file(name);
      if (content.empty()) {
        throw PictureFailure(std::string(kFolder) + file + ":" + std::to_string(line_number) +
                             ": there is no shader file '" + name + "'");
      }
      shader.text += "#line 1 " + std::to_string(shader.files.size()) + '\n';
      expand(name, content, shader);
    }
    shader.text += "#line " + std::to_string(line_number + 1) + ' ' + std::to_string(number) + '\n';
  }
}

std::string legend(const std::vector<std::string>& files) {
  std::string text;
  for (std::size_t i = 0; i < files.size(); ++i) {
    text += (i == 0 ? "file " : ", file ") + std::to_string(i) + " is " + kFolder + files[i];
  }
  return text;
}

std::string shader_log(GLuint shader) {
  GLint size = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &size);
  std::string log(static_cast<std::size_t>(std::max(size, 1)), '\0');
  glGetShaderInfoLog(shader, size, &size, log.data());
  log.resize(static_cast<std::size_t>(std::max(size, 0)));
  return log;
}

std::string program_log(GLuint program) {
  GLint size = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &size);
  std::string log(static_cast<std::size_t>(std::max(size, 1)), '\0');
  glGetProgramInfoLog(program, size, &size, log.data());
  log.resize(static_cast<std::size_t>(std::max(size, 0)));
  return log;
}

Shader compile_file(GLenum stage, const std::string& name, const std::string& defines) {
  const std::string_view text = shader_file(name);
  if (text.empty()) throw PictureFailure("there is no shader file '" + std::string(kFolder) + name + "'");
  return compile_shader(stage, name, text, defines);
}

/// Puts `defines` behind the first line, which says the version; the numbers of the lines that follow stay.
void insert_defines(const std::string& defines, std::string& text) {
  if (defines.empty()) return;
  text.insert(text.find('\n') + 1, defines + "#line 2 0\n");
}

}  // namespace

Shader compile_shader(GLenum stage, const std::string& name, std::string_view text, const std::string& defines) {
  ExpandedShader expanded;
  expand(name, text, expanded);
  insert_defines(defines, expanded.text);
  Shader shader(glCreateShader(stage));
  const char* source = expanded.text.c_str();
  glShaderSource(shader.name(), 1, &source, nullptr);
  glCompileShader(shader.name());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    throw PictureFailure("the driver refuses shader " + std::string(kFolder) + name + " (" + legend(expanded.files) +
                         "):\n" + shader_log(shader.name()));
  }
  return shader;
}

Program build_program(const std::string& vertex, const std::string& fragment, const std::string& defines) {
  Program program(glCreateProgram());
  const Shader vertex_shader = compile_file(GL_VERTEX_SHADER, vertex, {});
  glAttachShader(program.name(), vertex_shader.name());
  Shader fragment_shader;
  if (!fragment.empty()) {
    fragment_shader = compile_file(GL_FRAGMENT_SHADER, fragment, defines);
    glAttachShader(program.name(), fragment_shader.name());
  }
  glLinkProgram(program.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (!linked) {
    throw PictureFailure("the driver cannot link shaders " + std::string(kFolder) + vertex +
                         (fragment.empty() ? "" : " and " + fragment) + ":\n" + program_log(program.name()));
  }
  return program;
}

}  // namespace thinwall
