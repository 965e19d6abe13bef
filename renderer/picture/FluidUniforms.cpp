#include "renderer/picture/FluidUniforms.hpp"

#include "renderer/picture/FrameUniforms.hpp"
#include "renderer/picture/GlObjects.hpp"

namespace thinwall {

void set_fluid_look(const FluidLook& look) {
  glUniform4f(0, static_cast<float>(linear_from_srgb(look.color[0])),
              static_cast<float>(linear_from_srgb(look.color[1])), static_cast<float>(linear_from_srgb(look.color[2])),
              static_cast<float>(1 / look.clarity));
  glUniform1f(1, static_cast<float>(look.cloudiness));
}

}  // namespace thinwall
