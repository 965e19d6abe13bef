#include "renderer/picture/ShaderProgram.hpp"

#include <gtest/gtest.h>

#include "renderer/device/OffscreenContext.hpp"
#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

class ShaderProgram : public testing::Test {
 protected:
  OffscreenContext context_{DeviceChoice{}};
  CurrentContext current_{context_};
};

std::string failure_of(const std::string& text) {
  try {
    compile_shader(GL_FRAGMENT_SHADER, "made_up.frag", text);
  } catch (const PictureFailure& failure) {
    return failure.what();
  }
  return "compiled";
}

TEST_F(ShaderProgram, ACompileErrorNamesTheFileAndItsIncludes) {
  const std::string message = failure_of("#version 450 core\n#include \"frame.glsl\"\nvoid main() { wrong; }\n");
  EXPECT_EQ(message.find("the driver refuses shader renderer/picture/shaders/made_up.frag (file 0 is "
                         "renderer/picture/shaders/made_up.frag, file 1 is renderer/picture/shaders/frame.glsl):\n"),
            0u)
      << message;
  // Line 3 of file 0, as Mesa and as NVIDIA write it.
  EXPECT_TRUE(message.find("0:3") != std::string::npos || message.find("0(3)") != std::string::npos) << message;
}

TEST_F(ShaderProgram, AMissingIncludeIsNamedWithItsLine) {
  EXPECT_EQ(failure_of("#version 450 core\n#include \"absent.glsl\"\n"),
            "renderer/picture/shaders/made_up.frag:2: there is no shader file 'absent.glsl'");
}

TEST_F(ShaderProgram, AMissingFileIsNamed) {
  EXPECT_THROW(build_program("absent.vert", ""), PictureFailure);
}

}  // namespace
}  // namespace thinwall
