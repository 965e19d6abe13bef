#include "renderer/picture/FluidPass.hpp"

#include <cstddef>
#include <numeric>

#include "renderer/picture/FluidUniforms.hpp"
#include "renderer/picture/ShaderProgram.hpp"
#include "renderer/picture/TwoSourceBlending.hpp"

namespace thinwall {
namespace {

/// The bit of the stencil that no part's number uses, see ScenePass.
constexpr GLuint kWithin = 0x80;

}  // namespace

FluidPass::FluidPass()
    : programs_{build_program("fluid.vert", "fluid.frag"), build_program("fluid.vert", "fluid_endoscope.frag")},
      triangles_(sizeof(FluidVertex),
                 {{0, 3, offsetof(FluidVertex, position)}, {1, 3, offsetof(FluidVertex, normal)}}) {}

void FluidPass::draw(std::span<const BodyFluid> fluids, Surroundings surroundings) {
  if (fluids.empty()) return;
  std::vector<FluidVertex> vertices;
  for (const BodyFluid& fluid : fluids) {
    vertices.insert(vertices.end(), fluid.surface.lid.begin(), fluid.surface.lid.end());
    vertices.insert(vertices.end(), fluid.surface.level.begin(), fluid.surface.level.end());
  }
  std::vector<std::uint32_t> indices(vertices.size());
  std::iota(indices.begin(), indices.end(), 0U);
  triangles_.upload(std::span<const FluidVertex>(vertices), indices);

  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glEnable(GL_STENCIL_TEST);
  const TwoSourceBlending blending;
  glUseProgram(programs_[static_cast<std::size_t>(surroundings)].name());
  std::size_t first = 0;
  for (const BodyFluid& fluid : fluids) {
    set_fluid_look(fluid.look);
    // Where no tissue is behind, nothing tells how deep the fluid is.
    glStencilMask(0);
    glStencilFunc(GL_NOTEQUAL, 0, 0xff);
    triangles_.draw(first, fluid.surface.lid.size());
    first += fluid.surface.lid.size();
    if (fluid.surface.level.empty()) continue;
    // What an odd number of the fan's triangles covers is inside the contour.
    glStencilMask(kWithin);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    triangles_.draw(first, fluid.surface.level.size());
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    // Less than: the bit and the number of a part. Each pixel is drawn once, for then the bit is gone.
    glStencilFunc(GL_LESS, kWithin, 0xff);
    glStencilOp(GL_ZERO, GL_KEEP, GL_ZERO);
    triangles_.draw(first, fluid.surface.level.size());
    first += fluid.surface.level.size();
  }
  glStencilMask(0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glDisable(GL_STENCIL_TEST);
  glDepthMask(GL_TRUE);
}

}  // namespace thinwall
