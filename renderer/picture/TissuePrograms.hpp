#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>

#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/LookUniforms.hpp"

namespace thinwall {

/// What lights the scene and lies around it.
enum class Surroundings {
  kStudio,
  kCavity  // of a body, lit by an endoscope
};

/// What shading a part of the tissue has to reckon with, beside its look.
struct TissueScene {
  Surroundings surroundings = Surroundings::kStudio;
  bool is_shadowed = true;       // false where the shadow map is empty
  std::size_t rods = 0;          // of tools, that shade what is near
  float smallest_footprint = 0;  // metres: no pixel of the part covers less of it
};

/// The lines that tell tissue.glsl what it can leave out: what a look does not have, what the scene does not have, and
/// what no pixel would show.
std::string tissue_defines(const LookUniforms& look, const TissueScene& scene);

/// The shaders of tissue, one for each set of such lines: a driver that runs them on the processor computes both sides
/// of every branch, so what does nothing has to be left out before. Each is compiled when it is first wanted.
class TissuePrograms {
 public:
  const Program& program_for(const LookUniforms& look, const TissueScene& scene);

 private:
  std::array<std::map<std::string, Program>, 2> programs_;  // (surroundings)
};

}  // namespace thinwall
