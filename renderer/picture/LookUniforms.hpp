#pragma once

#include <array>

#include "renderer/camera/View.hpp"
#include "renderer/shape/TissueSide.hpp"
#include "renderer/shape/VesselTree.hpp"

namespace thinwall {

/// A part's look as the shader reads it: the block `Look` of shaders/tissue.vert, in the std140 layout. Colours are
/// linear, lengths in metres.
struct LookUniforms {
  std::array<float, 4> flesh{};    // w: roughness
  std::array<float, 4> blood{};    // w: wetness
  std::array<float, 4> fat{};      // w: part that is covered
  std::array<float, 4> through{};  // w: clearness
  std::array<float, 4> scatter{};  // w: sheen
  std::array<float, 4> vessels{};  // strength, 1 / spacing, strength of the capillaries, strength of the whole pattern
  std::array<float, 4> relief{};   // slope, 1 / size, creases, ridges
  // Contrast of the patches, 1 / their size; zw of rims: where the layers meet; w of linings and beds: 1, and
  // the folds of linings beyond that.
  std::array<float, 4> pattern{};
  std::array<float, 4> tree_middle{};  // metres; w: 1 / half of the tree's length
  std::array<float, 4> tree_along{};   // of length one; w: number of trunks
  std::array<float, 4> tree_across{};  // of length one; w: half the width of a trunk, metres
  std::array<float, 4> tree_aside{};   // of length one, perpendicular to both; w: strength of the pores
  alignas(16) float lamp_size = 1;
};

/// Whether the part shows the layers of a wall that is cut through.
inline bool is_layered(const LookUniforms& look) {
  return look.pattern[2] > 0;
}

LookUniforms look_uniforms(const TissueLook& look, TissueSide side, const VesselTree& tree = {});

}  // namespace thinwall
