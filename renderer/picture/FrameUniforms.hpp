#pragma once

#include <array>
#include <optional>

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/SceneExtent.hpp"
#include "renderer/camera/View.hpp"
#include "renderer/shape/ToolShape.hpp"

namespace thinwall {

using Float4 = std::array<float, 4>;
using FloatMatrix4 = std::array<float, 16>;

/// How many rods shade the surfaces near them; further ones cast their shadow only.
inline constexpr std::size_t kMostRods = 3;

/// What all shaders know of a picture: the block `Frame` of shaders/frame.glsl, in the std140 layout.
struct FrameUniforms {
  FloatMatrix4 view_projection{};
  Float4 ray_middle{};           // line of sight; with ray_right and ray_up times clip coordinates, a pixel's ray
  Float4 ray_right{};            // w: 1 / picture width
  Float4 ray_up{};               // w: 1 / picture height
  Float4 tissue{};               // linear colour that metal mirrors; w: 1, in data views 0, where metal is grey
  Float4 sample_shift{};         // xy: where in its pixel the picture is sampled, off the middle, in clip coordinates
  FloatMatrix4 shadow_matrix{};  // world to shadow map, 0 to 1 on every axis
  Float4 camera_position{};  // metres; w: how many texels a tool's shadow is blurred by, over the depth of the shadow
                             // map between the tool and what it falls on
  Float4 scene_center{};     // w: scene size, metres
  Float4 floor{};            // x: height; y: 1 where a floor is drawn; z: half width of its shade map, metres;
                             // w: the field stop as tangent of the angle off the line of sight, 0 for none
  Float4 key_direction{};    // to the light; w: strength. Of an endoscope's lamp the place, metres; w: strength there
                             // times the square of the distance
  Float4 key_right{};        // of length one, horizontal, across the key light; w: darkening of the lens
  Float4 panels{};           // xy: horizontal direction to the front panel; zw: to the back panel
  Float4 fill_direction{};   // to the light; w: strength
  Float4
      environment{};  // x: strength; y: contrast; z: offset against self-shadow, metres; w: a pixel's height at depth 1
  Float4 background{};  // sRGB; w: exposure
  Float4 floor_key{};   // linear: what the lit floor shows of a white key light; w: 1 / picture width
  Float4 floor_sky{};   // linear: and of the light from all around; w: 1 / picture height
  Float4 rest_grid{};   // of what is told of stress-free places: the lowest; w: the step, both metres
  std::array<Float4, kMostRods> rod_start{};  // metres; w: radius squared
  std::array<Float4, kMostRods> rod_span{};   // from start to end; w: 1 / length squared
};

/// Where the lamps stand, in the world.
struct Studio {
  Vector3 key_direction;  // from the scene to the light that casts the shadow, of length one
  Vector3 fill_direction;
  Vector3 front;  // horizontal, from the scene to the viewer
  std::optional<Vector3> lamp_place =
      {};  // of an endoscope's lamp, which then is the light that casts the shadow, metres
};

/// Lamps around a scene that `camera` shows at time zero: the key light, unless given, from the upper left in front,
/// raking enough to show a dent. They stay when the camera moves on.
Studio arrange_studio(const LightsDefinition& lights, const Camera& camera);

/// An endoscope has its own lamp beside the lens of `camera` as it stands now, 4 mm above it.
Studio arrange_endoscope(const Camera& camera, const SceneExtent& extent);

/// Everything that follows from the view and the scene alone.
FrameUniforms frame_uniforms(const Camera& camera, const SceneExtent& extent, const ViewDefinition& view,
                             const Studio& studio, const std::vector<ToolRod>& rods, ImageSize size,
                             Ground ground = Ground::kFloor);

/// The same, sampled at `shift` (pixels, right and up) off the middles of the pixels of a picture of `size`.
FrameUniforms sampled_off_middle(FrameUniforms frame, std::array<double, 2> shift, ImageSize size);

/// The clip matrix of the light that casts the shadow: what `camera` shows of the scene seen from there.
Matrix4 key_light_matrix(const SceneExtent& extent, const Studio& studio, const Camera& camera);

/// How many pixels of a picture of `size` the map of that light is wide, on average where the picture shows tissue; 0
/// where it shows none.
double shadow_map_pixels(const Matrix4& light_matrix, const SceneExtent& extent, const Camera& camera, ImageSize size);

/// Texels on a side of a shadow map that is `pixels` wide, but for Tier::kDraft. A texel that is several pixels wide
/// shows as stairs along a shadow's border; in ordinary views none is, and what is finer there would only cost. The map
/// of a small lamp has to be finer: it shows tools too, whose borders are straight and lie close before the wall.
int shadow_resolution(Tier tier, double pixels, bool is_lamp_small);

/// sRGB to linear, each 0 to 1 (IEC 61966-2-1).
double linear_from_srgb(double value);

}  // namespace thinwall
