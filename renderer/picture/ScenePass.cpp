#include "renderer/picture/ScenePass.hpp"

#include <vector>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/look/ColorMap.hpp"
#include "renderer/picture/ShaderProgram.hpp"
#include "renderer/snapshot/SameTime.hpp"

namespace thinwall {
namespace {

/// Parts of a picture are told apart by 7 of a stencil's 8 bits, 0 being none; the last is that of tools, then the
/// fluid's.
void require_countable(std::size_t parts) {
  if (parts > 127) {
    throw PictureFailure("a picture holds at most 127 walls, caps, rims and linings of bodies, the snapshot has " +
                         std::to_string(parts));
  }
}

/// Pixels of tools until they are shaded: the bit of the stencil that no part's number uses.
constexpr GLint kTools = 0x80;

/// Pixels where the outside of a bed hides its inside, before there are tools.
constexpr GLint kOutsideOfBed = kTools;

/// Of the ring around the field stop, as stop.vert has them.
constexpr GLsizei kStopVertices = 2 * (64 + 1);

/// More steps than any channel has levels between two of them.
constexpr int kColorSteps = 1024;

Texture color_texture() {
  Texture texture = create_texture(GL_RGBA32F, kColorSteps, 1, GL_NEAREST);
  std::vector<float> colors;
  for (int step = 0; step < kColorSteps; ++step) {
    const Double3 color = color_map(step / (kColorSteps - 1.0));
    for (const double channel : color) colors.push_back(static_cast<float>(channel));
    colors.push_back(1);
  }
  glTextureSubImage2D(texture.name(), 0, 0, 0, kColorSteps, 1, GL_RGBA, GL_FLOAT, colors.data());
  return texture;
}

void limit_to(const ScreenArea& area) {
  glScissor(area.left, area.bottom, area.width, area.height);
}

}  // namespace

ScenePass::ScenePass()
    : surface_(build_program("surface.vert", "surface.frag")),
      tool_(build_program("tool.vert", "tool.frag")),
      field_stop_(build_program("stop.vert", "")),
      emptied_(build_program("screen.vert", "")),
      metal_{build_program("metal.vert", "metal.frag"), build_program("metal.vert", "metal_endoscope.frag")},
      ground_{build_program("screen.vert", "floor.frag"), build_program("screen.vert", "drape.frag"),
              build_program("bed.vert", "bed.frag")},
      weave_(build_program("screen.vert", "weave.frag")),
      highlight_(build_program("screen.vert", "highlight.frag")),
      data_(build_program("screen.vert", "data.frag")),
      colors_(color_texture()),
      no_vertices_(create_vertex_array()),
      look_(create_buffer()) {
  glNamedBufferStorage(look_.name(), sizeof(LookUniforms), nullptr, GL_DYNAMIC_STORAGE_BIT);
}

void ScenePass::draw_ground(const PictureTarget& target, Ground ground, const FieldStop& stop) const {
  target.begin_backdrop();
  glDisable(GL_DEPTH_TEST);
  glUseProgram(ground_[static_cast<std::size_t>(ground)].name());
  glEnable(GL_SCISSOR_TEST);
  limit_to(area_within(stop, target.backdrop_size()));
  draw_screen();
  glDisable(GL_SCISSOR_TEST);
}

void ScenePass::draw_weave(const PictureTarget& target) const {
  target.begin_color();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_EQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  glUseProgram(weave_.name());
  draw_screen();
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void ScenePass::close_field_stop(const PictureTarget& target) const {
  target.begin_surface();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glUseProgram(field_stop_.name());
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, kStopVertices);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void ScenePass::draw_bed(const SceneMeshes& meshes, const TissuePart& part, GLint number, const PictureTarget& target,
                         const FloatMatrix4& view_projection) const {
  const auto paint = [](GLboolean on) { glColorMask(on, on, on, on); };
  paint(GL_FALSE);
  glCullFace(GL_FRONT);
  glStencilFunc(GL_ALWAYS, kOutsideOfBed, 0xff);
  meshes.tissue().draw(part.first_index, part.index_count);
  paint(GL_TRUE);
  glCullFace(GL_BACK);
  glStencilFunc(GL_ALWAYS, number, 0xff);
  meshes.tissue().draw(part.first_index, part.index_count);
  // As if nothing had been there.
  paint(GL_FALSE);
  glStencilFunc(GL_EQUAL, kOutsideOfBed, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
  glDepthFunc(GL_ALWAYS);
  glDepthRange(1, 1);
  glDisable(GL_CULL_FACE);
  glUseProgram(emptied_.name());
  glEnable(GL_SCISSOR_TEST);
  limit_to(screen_area(part.bounds, view_projection, target.size()));
  draw_screen();
  glDisable(GL_SCISSOR_TEST);
  glUseProgram(surface_.name());
  glEnable(GL_CULL_FACE);
  glDepthRange(0, 1);
  glDepthFunc(GL_LESS);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  paint(GL_TRUE);
}

void ScenePass::draw_surface(const SceneMeshes& meshes, const PictureTarget& target,
                             const FloatMatrix4& view_projection) const {
  require_countable(meshes.parts().size());
  target.begin_surface();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glStencilMask(0xff);
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glUseProgram(surface_.name());
  glEnable(GL_CULL_FACE);
  // Before all else, since they take away what was drawn where their outside is seen.
  for (std::size_t i = 0; i < meshes.parts().size(); ++i) {
    const TissuePart& part = meshes.parts()[i];
    if (part.side != TissueSide::kBed) continue;
    glUniform1i(0, is_layered(part.look) ? 1 : 0);
    draw_bed(meshes, part, static_cast<GLint>(i + 1), target, view_projection);
  }
  for (std::size_t i = 0; i < meshes.parts().size(); ++i) {
    const TissuePart& part = meshes.parts()[i];
    if (part.side == TissueSide::kBed) continue;
    glStencilFunc(GL_ALWAYS, static_cast<GLint>(i + 1), 0xff);
    glUniform1i(0, is_layered(part.look) ? 1 : 0);
    if (SceneMeshes::is_seen_through_opening(part, view_projection)) {
      // Where it crosses the wall, as a crumpled one does, what lies beside the opening stays hidden.
      glCullFace(GL_BACK);
      glEnable(GL_SCISSOR_TEST);
      limit_to(screen_area(*part.opening, view_projection, target.size()));
      meshes.draw_seen_lining(part, view_projection);
      glDisable(GL_SCISSOR_TEST);
      continue;
    }
    // The triangles that face the viewer first: of what they hide nothing is computed.
    glCullFace(GL_BACK);
    meshes.tissue().draw(part.first_index, part.index_count);
    if (part.is_closed && lies_ahead(part.body_bounds, view_projection)) continue;
    glCullFace(GL_FRONT);
    meshes.tissue().draw(part.first_index, part.index_count);
  }
  glDisable(GL_CULL_FACE);
}

void ScenePass::draw_tools(const SceneMeshes& meshes, const PictureTarget& target, const FloatMatrix4& view_projection,
                           Surroundings surroundings) const {
  target.begin_tools();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, kTools, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glUseProgram(tool_.name());
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  meshes.tools().draw();
  glDisable(GL_CULL_FACE);

  target.begin_color();
  glDisable(GL_DEPTH_TEST);
  // What is shaded counts as empty from then on: of tissue behind tools nothing is shaded, and no fluid lies on them.
  glStencilFunc(GL_EQUAL, kTools, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
  glUseProgram(metal_[static_cast<std::size_t>(surroundings)].name());
  glEnable(GL_SCISSOR_TEST);
  limit_to(meshes.tool_area(view_projection, target.size()));
  draw_screen();
  glDisable(GL_SCISSOR_TEST);
}

void ScenePass::shade_tissue(const SceneMeshes& meshes, const PictureTarget& target, const FrameUniforms& frame,
                             Surroundings surroundings, bool is_shadowed) {
  const FloatMatrix4& view_projection = frame.view_projection;
  target.begin_color();
  glDisable(GL_DEPTH_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glBindBufferBase(GL_UNIFORM_BUFFER, 1, look_.name());
  glEnable(GL_SCISSOR_TEST);
  for (std::size_t i = 0; i < meshes.parts().size(); ++i) {
    const TissuePart& part = meshes.parts()[i];
    const bool has_window = SceneMeshes::is_seen_through_opening(part, view_projection);
    const ScreenArea area = screen_area(has_window ? *part.opening : part.bounds, view_projection, target.size());
    if (area.width == 0 || area.height == 0) continue;
    limit_to(area);
    const float smallest_footprint = frame.environment[3] * nearest_depth(part.bounds, view_projection);
    const TissueScene scene{surroundings, is_shadowed, meshes.rods().size(), smallest_footprint};
    glUseProgram(tissue_.program_for(part.look, scene).name());
    glNamedBufferSubData(look_.name(), 0, sizeof(LookUniforms), &part.look);
    glStencilFunc(GL_EQUAL, static_cast<GLint>(i + 1), 0xff);
    draw_screen();
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
}

void ScenePass::mark(const SceneMeshes& meshes, const std::vector<HighlightDefinition>& highlights, double time) const {
  if (highlights.empty()) return;
  glEnable(GL_STENCIL_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(highlight_.name());
  for (const auto& [body, center, radius, color, begin, end] : highlights) {
    if (time < begin - kSameTime || time > end + kSameTime) continue;
    glUniform4f(0, static_cast<float>(center[0]), static_cast<float>(center[1]), static_cast<float>(center[2]),
                static_cast<float>(radius));
    glUniform3f(1, static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2]));
    for (std::size_t i = 0; i < meshes.parts().size(); ++i) {
      if (meshes.parts()[i].body != body || meshes.parts()[i].side != TissueSide::kOutside) continue;
      glStencilFunc(GL_EQUAL, static_cast<GLint>(i + 1), 0xff);
      draw_screen();
    }
  }
  glDisable(GL_BLEND);
  glDisable(GL_STENCIL_TEST);
}

void ScenePass::shade_data(const PictureTarget& target, DataScale scale) const {
  target.begin_color();
  glDisable(GL_DEPTH_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glStencilFunc(GL_NOTEQUAL, 0, 0xff);
  glBindTextureUnit(5, colors_.name());
  glUseProgram(data_.name());
  glUniform1i(0, scale == DataScale::kRoot ? 1 : 0);
  draw_screen();
  glDisable(GL_STENCIL_TEST);
}

void ScenePass::draw_screen() const {
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace thinwall
