#pragma once

#include <span>
#include <string_view>

#include "renderer/look/TissueLook.hpp"

namespace thinwall {

/// What comes out of a cut, in a thin layer.
inline constexpr FluidLook kFreshBlood = {.color = {0.26, 0.012, 0.014}, .clarity = 0.00016, .cloudiness = 1};

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

/// What is bare beside a cut, where the outermost layer has drawn back, as a film of hardly any depth: flesh that has
/// soaked up some of the blood beside it, so that the edge stands out from what lies below.
FluidLook bare_flesh(const TissueLook& look);

}  // namespace thinwall
