#include "renderer/picture/LookUniforms.hpp"

#include <algorithm>

#include "renderer/picture/FrameUniforms.hpp"

namespace thinwall {
namespace {

Double3 mixed(const Double3& a, const Double3& b, double part) {
  Double3 result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = (1 - part) * a[k] + part * b[k];
  return result;
}

/// Moist, and without the vessels of the outer side.
TissueLook rim_look(TissueLook look) {
  look.vessels = look.capillaries = look.clearness = look.ridges = look.creases = look.pores = 0;
  look.wetness = std::max(look.wetness, 0.95);
  look.roughness = std::min(look.roughness, 0.35);
  // Cut fibres and lobules are uneven, which breaks what they mirror.
  look.relief = std::max(look.relief, 0.35);
  look.relief_size = std::clamp(look.relief_size, 0.0011, look.layers.grain_size);
  return look;
}

/// Closes the fluid where no wall is: as flesh that was cut across, paler than the outer side.
TissueLook cap_look(TissueLook look) {
  const double relief = std::max(look.relief, 0.10);
  look = rim_look(look);
  look.color = mixed(mixed(look.color, look.layers.middle, 0.3), {0.88, 0.78, 0.70}, 0.2);
  look.relief = std::min(relief, 0.16);
  return look;
}

/// Dark and wet, in hills as mucosa is: those that are turned to the lens glisten wherever it looks.
TissueLook lining_look(TissueLook look) {
  look.color = mixed(look.layers.inner, {0.45, 0.10, 0.09}, 0.35);
  look.wetness = std::max(look.wetness, 0.95);
  look.clearness = look.fattiness = look.ridges = look.vessels = look.capillaries = look.pores = 0;
  look.creases = 0.35;
  look.relief = 0.36;
  look.relief_size = std::max(look.relief_size, 0.0038);
  look.sheen = 0;
  return look;
}

/// Lobules of fat with fascia between them, wet with blood.
TissueLook bed_look(TissueLook look) {
  look.color = {0.60, 0.27, 0.20};
  look.blood = {0.46, 0.07, 0.07};
  look.fat = {0.86, 0.62, 0.30};
  look.roughness = 0.35;
  look.wetness = 0.95;
  look.patches = 0.95;
  look.patch_size = 0.006;
  look.vessels = 0.5;
  look.vessel_spacing = 0.005;
  look.capillaries = 0.6;
  look.fattiness = 0.52;
  look.clearness = look.ridges = look.creases = look.pores = look.sheen = 0;
  look.relief = 0.22;
  look.relief_size = 0.0022;
  return look;
}

TissueLook side_look(const TissueLook& look, TissueSide side) {
  switch (side) {
    case TissueSide::kRim:
      return rim_look(look);
    case TissueSide::kLining:
    case TissueSide::kCapLining:
      return lining_look(look);
    case TissueSide::kCap:
      return cap_look(look);
    case TissueSide::kBed:
      return bed_look(look);
    case TissueSide::kOutside:
      break;
  }
  return look;
}

/// As of LookUniforms::pattern: 0 where light comes from all around.
double enclosure(const TissueLook& look, TissueSide side) {
  if (side == TissueSide::kLining) return 1 + look.folds;
  return side == TissueSide::kCapLining || side == TissueSide::kBed ? 1 : 0;
}

Double3 double3(Vector3 values) {
  return {values.x, values.y, values.z};
}

std::array<float, 4> packed(const Double3& values, double w) {
  return {static_cast<float>(values[0]), static_cast<float>(values[1]), static_cast<float>(values[2]),
          static_cast<float>(w)};
}

std::array<float, 4> linear4(const Double3& color, double w) {
  return packed({linear_from_srgb(color[0]), linear_from_srgb(color[1]), linear_from_srgb(color[2])}, w);
}

}  // namespace

LookUniforms look_uniforms(const TissueLook& given, TissueSide side, const VesselTree& tree) {
  const TissueLook look = side_look(given, side);
  const bool is_rim = side == TissueSide::kRim;
  // The layers of a rim stand in for the colours that its pattern does without.
  const Double3& flesh = is_rim ? look.layers.outer : look.color;
  const Double3& blood = is_rim ? look.layers.middle : look.blood;
  const Double3& fat = is_rim ? look.layers.inner : look.fat;
  return {.flesh = linear4(flesh, look.roughness),
          .blood = linear4(blood, look.wetness),
          .fat = linear4(fat, is_rim ? 0 : look.fattiness),
          .through = linear4(look.through, look.clearness),
          .scatter = packed(look.scatter, look.sheen),
          .vessels = packed({look.vessels, 1 / look.vessel_spacing, look.capillaries}, look.mottling),
          .relief = packed({look.relief, 1 / look.relief_size, look.creases}, look.ridges),
          .pattern = packed({look.patches, 1 / look.patch_size, is_rim ? look.layers.outer_part : 0},
                            is_rim ? 1 - look.layers.inner_part : enclosure(look, side)),
          .tree_middle = packed(double3(tree.middle), 1 / tree.half_length),
          .tree_along = packed(double3(tree.along), vessel_trunks(tree, look.vessel_spacing)),
          .tree_across = packed(double3(tree.across), 0.036 * look.vessel_spacing),
          .tree_aside = packed(double3(cross(tree.along, tree.across)), look.pores),
          .lamp_size = static_cast<float>(look.lamp_size)};
}

}  // namespace thinwall
