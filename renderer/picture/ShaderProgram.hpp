#pragma once

#include <string>
#include <string_view>

#include "renderer/picture/GlObjects.hpp"

namespace thinwall {

/// The text of a file of renderer/picture/shaders, as compiled into the program; empty when there is none of that name.
std::string_view shader_file(std::string_view name);

/// Compiles and links files of renderer/picture/shaders; `fragment` may be empty for a depth-only pass. A line
/// `#include "NAME"` is replaced by that file. Throws PictureFailure with the driver's message and the files that its
/// numbers mean. `defines`: lines that the fragment shader begins with, after its version.
Program build_program(const std::string& vertex, const std::string& fragment, const std::string& defines = {});

/// Compiles one shader from text given by the caller, who names it `name` in messages; otherwise like build_program.
Shader compile_shader(GLenum stage, const std::string& name, std::string_view text, const std::string& defines = {});

}  // namespace thinwall
