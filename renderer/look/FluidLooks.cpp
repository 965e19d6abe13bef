#include "renderer/look/FluidLooks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace thinwall {
namespace {

constexpr std::array kFluidLooks = {
    NamedFluid{"serum", "clear, hardly straw-coloured", {}},
    NamedFluid{
        "bile", "golden brown to dark green", {.color = {0.30, 0.245, 0.05}, .clarity = 0.0012, .cloudiness = 1}},
    NamedFluid{"gastric_juice",
               "pale and slightly cloudy",
               {.color = {0.60, 0.54, 0.34}, .clarity = 0.005, .cloudiness = 0.7}},
    NamedFluid{"blood", "dark red and opaque", {.color = {0.34, 0.015, 0.02}, .clarity = 0.0002, .cloudiness = 1}},
    NamedFluid{"water", "clear", {.color = {0.66, 0.76, 0.76}, .clarity = 0.06, .cloudiness = 0.03}},
    NamedFluid{"none", "nothing is seen of it, as of a gel or of solid tissue", {.color = {0, 0, 0}, .clarity = 0}},
};

}  // namespace

std::span<const NamedFluid> fluid_looks() {
  return kFluidLooks;
}

const FluidLook* find_fluid_look(std::string_view fluid) {
  const auto row = std::ranges::find(kFluidLooks, fluid, &NamedFluid::fluid);
  return row == kFluidLooks.end() ? nullptr : &row->look;
}

FluidLook bare_flesh(const TissueLook& look) {
  constexpr double kSoaked = 0.5;  // of freely bleeding flesh, part that is blood
  const double blood = kSoaked * std::cbrt(look.bleeding);
  FluidLook bare = {.color = {}, .clarity = 0.00005, .cloudiness = 1};
  for (std::size_t c = 0; c < 3; ++c) {
    const double flesh = 0.5 * (look.layers.outer[c] + look.layers.middle[c]);
    bare.color[c] = std::lerp(flesh, kFreshBlood.color[c], blood);
  }
  return bare;
}

}  // namespace thinwall
