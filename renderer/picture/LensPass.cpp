#include "renderer/picture/LensPass.hpp"

#include <algorithm>

#include "renderer/picture/ShaderProgram.hpp"

namespace thinwall {
namespace {

/// Tangent that stands for all angles where a lens never folds.
constexpr double kFarthestTangent = 1e9;

}  // namespace

LensPass::LensPass() : program_(build_program("lens.vert", "lens.frag")), no_vertices_(create_vertex_array()) {}

void LensPass::draw(const PictureTarget& target, const Camera& camera, const Camera& pinhole) const {
  target.begin_lens();
  glDisable(GL_DEPTH_TEST);
  glUseProgram(program_.name());
  const auto [k1, k2, p1, p2, k3] = camera.lens.distortion();
  glUniform4f(0, static_cast<float>(k1), static_cast<float>(k2), static_cast<float>(p1), static_cast<float>(p2));
  glUniform1f(1, static_cast<float>(k3));
  glUniform4f(2, static_cast<float>(camera.tangent_x), static_cast<float>(camera.tangent_y),
              static_cast<float>(pinhole.tangent_x), static_cast<float>(pinhole.tangent_y));
  glUniform2f(3, 1.0F / static_cast<float>(target.size().width), 1.0F / static_cast<float>(target.size().height));
  glUniform1f(4, static_cast<float>(std::min(camera.lens.unfolded_radius(), kFarthestTangent)));
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace thinwall
