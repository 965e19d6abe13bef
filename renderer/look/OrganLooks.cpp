#include "renderer/look/OrganLooks.hpp"

#include <algorithm>
#include <array>

#include "renderer/look/FluidLooks.hpp"

namespace thinwall {
namespace {

constexpr WallLayers kHollowOrgan = {};
// Below a thin capsule all is of lobules.
constexpr WallLayers kSolidOrgan = {.outer = {0.56, 0.34, 0.28},
                                    .middle = {0.33, 0.105, 0.078},
                                    .inner = {0.36, 0.12, 0.088},
                                    .outer_part = 0.01,
                                    .inner_part = 0.97,
                                    .grain_size = 0.0014};
constexpr WallLayers kSkinLayers = {.outer = {0.80, 0.56, 0.47},
                                    .middle = {0.90, 0.60, 0.56},
                                    .inner = {0.92, 0.76, 0.48},
                                    .outer_part = 0.10,
                                    .inner_part = 0.35};

const std::array kOrganLooks = {
    OrganLook{"tissue", "soft tissue under a moist membrane", {}},
    OrganLook{"gallbladder",
              "blue-green, bile shining through a smooth serosa with red vessels",
              {.color = {0.49, 0.51, 0.405},
               .roughness = 0.42,
               .wetness = 0.95,
               .patches = 0.9,
               .patch_size = 0.016,
               .blood = {0.42, 0.07, 0.08},
               .vessels = 0.95,
               .vessel_spacing = 0.010,
               .capillaries = 0.75,
               .fat = {0.84, 0.70, 0.36},
               .fattiness = 0.22,
               .through = {0.12, 0.23, 0.16},
               .clearness = 0.42,
               .sheen = 0.35,
               .relief = 0.07,
               .relief_size = 0.0019,
               .layers = {.outer = {0.56, 0.46, 0.38},
                          .middle = {0.46, 0.14, 0.12},
                          .inner = {0.52, 0.40, 0.15},
                          .outer_part = 0.09,
                          .inner_part = 0.30},
               .contents = *find_fluid_look("bile"),
               .bleeding = 0.7}},
    OrganLook{"stomach",
              "pale pink and glossy with fine vessels",
              {.color = {0.80, 0.51, 0.46},
               .roughness = 0.40,
               .wetness = 0.9,
               .patches = 0.4,
               .patch_size = 0.020,
               .blood = {0.60, 0.12, 0.15},
               .vessels = 0.6,
               .vessel_spacing = 0.016,
               .capillaries = 0.6,
               .fattiness = 0.06,
               .clearness = 0.10,
               .sheen = 0.4,
               .relief = 0.10,
               .relief_size = 0.0022,
               .folds = 1,
               .layers = kHollowOrgan,
               .contents = *find_fluid_look("gastric_juice")}},
    OrganLook{"liver",
              "brown-red under the smooth capsule of Glisson",
              {.color = {0.29, 0.10, 0.075},
               // No duller than the wet layer, beside whose light a dark organ would be milky.
               .roughness = 0.26,
               .wetness = 1.0,
               // So large and smooth that it would show whole lamps.
               .lamp_size = 0.35,
               // Of lobules, as wide as seeds.
               .patches = 0.42,
               .patch_size = 0.0017,
               .blood = {0.26, 0.05, 0.05},
               .vessels = 0.0,
               .vessel_spacing = 0.030,
               .capillaries = 0,
               .through = {0.30, 0.07, 0.06},
               .clearness = 0.05,
               .scatter = {0.0040, 0.0011, 0.0007},
               .sheen = 0,
               .relief = 0.045,
               .relief_size = 0.0055,
               .layers = kSolidOrgan,
               .contents = *find_fluid_look("none")}},
    OrganLook{"skin",
              "dry, with pores, fine lines and uneven redness",
              {.color = {0.83, 0.60, 0.50},
               .roughness = 0.44,
               .wetness = 0.15,
               .patches = 0.9,
               .patch_size = 0.010,
               .blood = {0.68, 0.36, 0.33},
               .vessels = 0.0,
               .vessel_spacing = 0.020,
               .capillaries = 0.0,
               .clearness = 0.04,
               .sheen = 0.25,
               .relief = 0.34,
               .relief_size = 0.00042,
               .creases = 0.9,
               .pores = 1,
               .layers = kSkinLayers,
               .contents = *find_fluid_look("none"),
               .bed = 0.004}},
    OrganLook{"vessel",
              "a smooth tube with fine vessels of its own",
              {.color = {0.80, 0.50, 0.46},
               .roughness = 0.38,
               .wetness = 0.85,
               .patches = 0.35,
               .patch_size = 0.006,
               .blood = {0.55, 0.10, 0.12},
               .vessels = 0.3,
               .vessel_spacing = 0.004,
               .capillaries = 0.5,
               .through = {0.34, 0.05, 0.07},
               .clearness = 0.30,
               .sheen = 0.5,
               .relief = 0.06,
               .relief_size = 0.0009,
               .contents = *find_fluid_look("blood")}},
    OrganLook{"fingerpad",
              "skin with friction ridges",
              {.color = {0.86, 0.61, 0.52},
               .roughness = 0.50,
               .wetness = 0.15,
               .patches = 0.45,
               .patch_size = 0.009,
               .blood = {0.74, 0.36, 0.33},
               .vessels = 0.0,
               .vessel_spacing = 0.020,
               .capillaries = 0.0,
               .clearness = 0.04,
               .sheen = 0.2,
               .relief = 0.06,
               .relief_size = 0.0007,
               .creases = 0.5,
               .ridges = 0.30,
               .layers = kSkinLayers,
               .contents = *find_fluid_look("none"),
               .bed = 0.004}},
};

}  // namespace

std::span<const OrganLook> organ_looks() {
  return kOrganLooks;
}

const TissueLook* find_organ_look(std::string_view organ) {
  const auto row = std::ranges::find(kOrganLooks, organ, &OrganLook::organ);
  return row == kOrganLooks.end() ? nullptr : &row->look;
}

}  // namespace thinwall
