#pragma once

#include "renderer/look/TissueLook.hpp"

namespace thinwall {

/// Gives the program in use, of film.glsl or fluid.glsl, the look of the fluid that it draws.
void set_fluid_look(const FluidLook& look);

}  // namespace thinwall
