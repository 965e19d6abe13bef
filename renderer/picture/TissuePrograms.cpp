#include "renderer/picture/TissuePrograms.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "renderer/picture/FrameUniforms.hpp"
#include "renderer/picture/ShaderProgram.hpp"

namespace thinwall {
namespace {

/// As `dust_seen` of pattern.glsl: from there on it is zero.
constexpr float kUnseenDust = 0.55F;
constexpr float kDustWaves = 2.0F;  // to those of the relief

}  // namespace

std::string tissue_defines(const LookUniforms& look, const TissueScene& scene) {
  std::ostringstream lines;
  lines << std::boolalpha;
  const auto define = [&lines](const char* name, auto value) { lines << "#define " << name << ' ' << value << '\n'; };
  const bool is_pored = look.tree_aside[3] > 0;
  define("LAYERED", is_layered(look));
  define("ENCLOSED", look.pattern[3] > 0);
  define("FATTY", look.fat[3] > 0);
  define("VESSELED", std::max(look.vessels[0], look.vessels[2]) > 0);
  define("CLEAR", look.through[3] > 0);
  define("CREASED", look.relief[2] > 0);
  define("PORED", is_pored);
  define("RIDGED", look.relief[3] > 0);
  define("FOLDED", !is_layered(look) && look.pattern[3] > 1);
  // Nothing of skin is finer than its lines.
  define("DUSTED", !is_pored && kDustWaves * look.relief[1] * scene.smallest_footprint < kUnseenDust);
  define("SHADOWED", scene.is_shadowed);
  // The lamps of a studio are large, which shows within wounds; an endoscope's is small.
  if (look.pattern[3] > 0 && scene.surroundings == Surroundings::kStudio) define("SOFT_SHADOW", true);
  if (scene.is_shadowed && scene.rods > 0) define("TOOLS_SHADE", true);
  define("ROD_COUNT", std::min(scene.rods, kMostRods));
  return lines.str();
}

const Program& TissuePrograms::program_for(const LookUniforms& look, const TissueScene& scene) {
  const bool is_cavity = scene.surroundings == Surroundings::kCavity;
  std::map<std::string, Program>& programs = programs_[is_cavity ? 1 : 0];
  const std::string defines = tissue_defines(look, scene);
  const auto found = programs.find(defines);
  if (found != programs.end()) return found->second;
  Program program = build_program("tissue.vert", is_cavity ? "tissue_endoscope.frag" : "tissue.frag", defines);
  return programs.emplace(defines, std::move(program)).first->second;
}

}  // namespace thinwall
