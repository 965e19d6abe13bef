#include "renderer/picture/ScenePass.hpp"

#include "renderer/picture/FrameUniforms.hpp"
#include "renderer/picture/ShaderProgram.hpp"

namespace thinwall {

ScenePass::ScenePass()
    : metal_(build_program("metal.vert", "metal.frag")),
      tissue_(build_program("tissue.vert", "tissue.frag")),
      floor_(build_program("floor.vert", "floor.frag")),
      no_vertices_(create_vertex_array()) {}

void ScenePass::draw(const SceneMeshes& meshes) const {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glUseProgram(metal_.name());
  meshes.tools().draw();
  draw_tissue(meshes);
  // The floor comes last, at the far end of depth, so that it is computed only where it is seen.
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glUseProgram(floor_.name());
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthMask(GL_TRUE);
}

void ScenePass::draw_tissue(const SceneMeshes& meshes) const {
  glUseProgram(tissue_.name());
  for (const TissuePart& part : meshes.parts()) {
    const TissueLook& look = part.look;
    glUniform3f(0, static_cast<float>(linear_from_srgb(look.color[0])),
                static_cast<float>(linear_from_srgb(look.color[1])),
                static_cast<float>(linear_from_srgb(look.color[2])));
    glUniform1f(1, static_cast<float>(look.roughness));
    glUniform1f(2, static_cast<float>(look.wetness));
    glUniform1f(3, static_cast<float>(look.mottling));
    meshes.tissue().draw(part.first_index, part.index_count);
  }
}

}  // namespace thinwall
