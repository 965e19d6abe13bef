#include "renderer/picture/FloorShade.hpp"

namespace thinwall {
namespace {

constexpr int kResolution = FloorCover::kResolution;

FloorMap map_of(const FrameUniforms& frame) {
  const auto& [x, y, z, size] = frame.scene_center;
  return {.center = {x, y, z}, .size = size, .height = frame.floor[0], .half_width = frame.floor[2]};
}

}  // namespace

FloorShade::FloorShade() : map_(create_texture(GL_RG8, kResolution, kResolution, GL_LINEAR)) {
  clear();
}

void FloorShade::lay(const SceneMeshes& meshes, const FrameUniforms& frame, Vector3 toward_light) {
  cover_.begin(map_of(frame), toward_light);
  cover_.stand(meshes.tissue_vertices());
  for (const TissuePart& part : meshes.parts()) {
    cover_.lay(meshes.tissue_corners().subspan(part.first_index, part.index_count), part.is_closed);
  }
  cover_.stand(meshes.tool_vertices());
  cover_.lay(meshes.tool_corners(), true);
  taken_ = cover_.blurred();
}

void FloorShade::upload() const {
  glTextureSubImage2D(map_.name(), 0, 0, 0, kResolution, kResolution, GL_RG, GL_UNSIGNED_BYTE, taken_.data());
  glBindTextureUnit(1, map_.name());
}

void FloorShade::clear() const {
  glClearTexImage(map_.name(), 0, GL_RG, GL_UNSIGNED_BYTE, nullptr);
  glBindTextureUnit(1, map_.name());
}

}  // namespace thinwall
