#pragma once

#include <array>

#include "renderer/picture/FrameUniforms.hpp"
#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/PictureTarget.hpp"
#include "renderer/picture/SceneMeshes.hpp"
#include "renderer/picture/TissuePrograms.hpp"

namespace thinwall {

/// Draws tissue, tools and ground, one function after the other; the Frame block and the maps must be bound.
class ScenePass {
 public:
  ScenePass();

  /// What lies below the scene, as backdrop, within the field stop.
  void draw_ground(const PictureTarget& target, Ground ground, const FieldStop& stop) const;

  /// The threads of a drape, where nothing lies before it: they are finer than a backdrop shows.
  void draw_weave(const PictureTarget& target) const;

  /// Keeps all that is drawn from then on within the field stop of an endoscope: outside it depth is as near as can be.
  void close_field_stop(const PictureTarget& target) const;

  /// What is seen of the tissue, as geometry. `view_projection`, here and below: world to clip coordinates.
  void draw_surface(const SceneMeshes& meshes, const PictureTarget& target, const FloatMatrix4& view_projection) const;

  /// Before the tissue is shaded, which then leaves out what they hide.
  void draw_tools(const SceneMeshes& meshes, const PictureTarget& target, const FloatMatrix4& view_projection,
                  Surroundings surroundings) const;

  /// The numbers of a data view in its place.
  void shade_data(const PictureTarget& target, DataScale scale) const;

  /// Its colours. `is_shadowed`: as of TissueScene.
  void shade_tissue(const SceneMeshes& meshes, const PictureTarget& target, const FrameUniforms& frame,
                    Surroundings surroundings, bool is_shadowed);

  /// What is marked of it: those of `highlights` that are shown at `time` (seconds).
  void mark(const SceneMeshes& meshes, const std::vector<HighlightDefinition>& highlights, double time) const;

 private:
  void draw_screen() const;

  /// The inside of what an open sheet lies on, which is seen through wounds alone: where its outside would be seen,
  /// from low beside the sheet, there is nothing. `number`: of the part, from 1.
  void draw_bed(const SceneMeshes& meshes, const TissuePart& part, GLint number, const PictureTarget& target,
                const FloatMatrix4& view_projection) const;

  Program surface_;
  Program tool_;
  Program field_stop_;
  Program emptied_;
  TissuePrograms tissue_;
  std::array<Program, 2> metal_;   // (surroundings)
  std::array<Program, 3> ground_;  // (kinds of ground)
  Program weave_;
  Program highlight_;
  Program data_;
  Texture colors_;  // of data views
  VertexArray no_vertices_;
  Buffer look_;  // of the part that is shaded
};

}  // namespace thinwall
