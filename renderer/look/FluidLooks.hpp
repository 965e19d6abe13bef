#pragma once

#include <span>
#include <string_view>

#include "renderer/look/TissueLook.hpp"

namespace thinwall {

/// A fluid that the scenario format knows.
struct NamedFluid {
  std::string_view fluid;  // the word of the scenario format
  std::string_view documentation;
  FluidLook look;
};

/// All of them; the last is none.
std::span<const NamedFluid> fluid_looks();

/// The look of the fluid of that name, or nullptr when there is none.
const FluidLook* find_fluid_look(std::string_view fluid);

}  // namespace thinwall
