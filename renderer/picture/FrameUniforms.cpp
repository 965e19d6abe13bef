#include "renderer/picture/FrameUniforms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "renderer/picture/ToolCover.hpp"

namespace thinwall {
namespace {

Float4 float4(Vector3 a, double w) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z), static_cast<float>(w)};
}

FloatMatrix4 float_matrix(const Matrix4& matrix) {
  FloatMatrix4 result;
  for (std::size_t i = 0; i < 16; ++i) result[i] = static_cast<float>(matrix.values[i]);
  return result;
}

/// Clip coordinates -1 to 1 to texture coordinates 0 to 1.
Matrix4 texture_matrix() {
  Matrix4 matrix;
  for (int i = 0; i < 3; ++i) {
    matrix(i, i) = 0.5;
    matrix(i, 3) = 0.5;
  }
  matrix(3, 3) = 1;
  return matrix;
}

Float4 mirrored_tissue(const LookDefinition& look) {
  // Beside the colours of numbers no other may be taken for one.
  constexpr float kGrey = 0.3F;
  if (look.data) return {kGrey, kGrey, kGrey, 0};
  const TissueLook tissue = look.bodies.empty() ? TissueLook{} : look.bodies.begin()->second;
  return {static_cast<float>(linear_from_srgb(tissue.color[0])), static_cast<float>(linear_from_srgb(tissue.color[1])),
          static_cast<float>(linear_from_srgb(tissue.color[2])), 1};
}

/// By `angle` (radians) around the upward axis.
Vector3 turned(Vector3 a, double angle) {
  return {std::cos(angle) * a.x - std::sin(angle) * a.y, std::sin(angle) * a.x + std::cos(angle) * a.y, a.z};
}

/// Linear, of green-blue cotton that has been washed often.
constexpr Double3 kDrapeColor = {0.040, 0.138, 0.150};

/// Lit by the key light a floor is some brighter than the background that it fades into.
void light_floor(FrameUniforms& frame, const ViewDefinition& view, Ground ground) {
  constexpr double kSkyIrradiance[] = {0.33, 0.36, 0.41};
  const double contrast = view.lights.environment_contrast;
  for (std::size_t i = 0; i < 3; ++i) {
    const double albedo =
        ground == Ground::kDrape ? kDrapeColor[i] : 3.2 * linear_from_srgb(view.look.background[i]) + 0.004;
    const double sky = view.lights.environment * (1 - contrast + contrast * kSkyIrradiance[i]);
    const double key = 2.1 * view.lights.key * std::max(0.0f, frame.key_direction[2]);
    frame.floor_key[i] = static_cast<float>(albedo * key);
    frame.floor_sky[i] = static_cast<float>(albedo * sky);
  }
}

/// The natural darkening of a lens goes with the fourth power of the cosine of the angle; endoscopes correct part of
/// it.
constexpr double kLensDarkening = 0.8;

/// What makes the middle of the scene as bright as lamps in the open do, wherever the endoscope is: its automatic
/// exposure.
double lamp_strength(const LightsDefinition& lights, const Camera& camera, const SceneExtent& extent) {
  const SceneExtent& subject = extent.subject();
  const Vector3 offset = subject.center - camera.position;
  // Close to the wall the brightness of the nearest part counts.
  const double distance = std::max(dot(offset, camera.forward), 0.25 * subject.size);
  return 1.6 * lights.endoscope * distance * distance;
}

/// What lies below a scene: in a body, where tissue is all around, always below the lens.
double ground_height(const Camera& camera, const SceneExtent& extent, const Studio& studio) {
  constexpr double kBelowTheLens = 0.1;  // over the scene's size
  if (!studio.lamp_place) return extent.floor_height;
  return std::min(extent.floor_height, camera.position.z - kBelowTheLens * extent.size);
}

}  // namespace

double linear_from_srgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

Studio arrange_studio(const LightsDefinition& lights, const Camera& camera) {
  const Vector3 toward_viewer{-camera.forward.x, -camera.forward.y, 0};
  const Vector3 front = length(toward_viewer) > 1e-6 ? normalized(toward_viewer) : Vector3{0, -1, 0};
  const Vector3 left{front.y, -front.x, 0};
  const Vector3 up{0, 0, 1};
  const Vector3 key = lights.key_direction ? vector3(*lights.key_direction) : 0.62 * left + 0.38 * front + 0.80 * up;
  return {normalized(key), normalized(-0.70 * left + 0.75 * front + 0.30 * up), front};
}

Studio arrange_endoscope(const Camera& camera, const SceneExtent& extent) {
  constexpr double kBesideTheLens = 0.004;  // metres
  const Vector3 place = camera.position + kBesideTheLens * camera.up;
  const Vector3 offset = place - extent.center;
  // Among the surfaces it lights what the camera sees, on whichever side the middle of the scene is.
  const Vector3 toward = length(offset) > extent.reach ? normalized(offset) : -camera.forward;
  return {.key_direction = toward, .fill_direction = toward, .front = {0, -1, 0}, .lamp_place = place};
}

/// The clip matrix of a light that sees the whole reach of the scene.
Matrix4 whole_light_matrix(const SceneExtent& extent, const Studio& studio) {
  // The shadows of upright tools would lie along the map's raster, whose steps are widest there; across it they are
  // finest, and the taps of shadow.glsl stand evenly.
  constexpr double kTurn = 0.25 * std::numbers::pi;
  const Vector3 level = perpendicular(studio.key_direction);
  const Vector3 right = std::cos(kTurn) * level + std::sin(kTurn) * cross(studio.key_direction, level);
  const Vector3 up = cross(studio.key_direction, right);
  if (studio.lamp_place) {
    const double distance = std::max(length(*studio.lamp_place - extent.center), 1e-3 * extent.size);
    const double half = 1.35 * extent.reach;
    // A lamp among the surfaces lights what lies before it, over a right angle.
    const double tangent = distance > 1.5 * half ? half / std::sqrt(distance * distance - half * half) : 1.0;
    const double nearest = std::max(0.1 * distance, distance - 2 * extent.reach);
    return perspective_matrix(tangent, tangent, nearest, distance + 2 * extent.reach) *
           eye_matrix(*studio.lamp_place, right, up, studio.key_direction);
  }
  const double half = 1.35 * extent.reach;
  const double distance = 8 * extent.reach;
  return parallel_matrix(half, 0, 2 * distance) *
         eye_matrix(extent.center + distance * studio.key_direction, right, up, studio.key_direction);
}

/// Clip coordinates, not divided.
std::array<double, 4> clip_place(const Matrix4& matrix, const Vector3& point) {
  std::array<double, 4> clip;
  for (int row = 0; row < 4; ++row) {
    clip[static_cast<std::size_t>(row)] =
        matrix(row, 0) * point.x + matrix(row, 1) * point.y + matrix(row, 2) * point.z + matrix(row, 3);
  }
  return clip;
}

/// A part of what a light sees, -1 to 1 on both axes.
struct LightWindow {
  std::array<double, 2> low{1, 1};
  std::array<double, 2> high{-1, -1};

  void add(const std::array<double, 4>& clip) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], clip[axis] / clip[3]);
      high[axis] = std::max(high[axis], clip[axis] / clip[3]);
    }
  }
  bool is_empty() const { return !(high[0] > low[0]) || !(high[1] > low[1]); }
};

/// The part of `whole` around `seen`, which `points` points have told, and what may lie between these. It goes in
/// steps, so that the shadow's raster stays still while a camera moves a little.
LightWindow around_seen(const LightWindow& whole, const LightWindow& seen, std::size_t points) {
  constexpr double kSteps = 16;
  const double between = 1 / std::sqrt(static_cast<double>(points));
  LightWindow part;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double step = (whole.high[axis] - whole.low[axis]) / kSteps;
    const double more = between * (seen.high[axis] - seen.low[axis]);
    part.low[axis] =
        whole.low[axis] + step * std::max(0.0, std::floor((seen.low[axis] - more - whole.low[axis]) / step));
    part.high[axis] =
        whole.high[axis] - step * std::max(0.0, std::floor((whole.high[axis] - seen.high[axis] - more) / step));
  }
  return part;
}

/// (points), how far the points at rest lie from the middle of a picture, over half of it; infinite behind the camera.
std::vector<double> places_beside(const SceneExtent& extent, const Camera& camera) {
  const Matrix4 picture = camera.matrix();
  std::vector<double> beside;
  for (const Vector3& point : extent.rest_points) {
    const std::array<double, 4> place = clip_place(picture, point);
    const double far = std::max(std::abs(place[0]), std::abs(place[1]));
    beside.push_back(place[3] > 0 ? far / place[3] : std::numeric_limits<double>::infinity());
  }
  return beside;
}

/// Half of the part of a picture that a light has to see, over half the picture; nothing where it shows too little.
/// `beside`: what places_beside gives.
std::optional<double> part_to_light(std::span<const double> beside) {
  constexpr double kBesidePicture = 1.15;  // what lies beside it at rest may come in
  constexpr double kWider = 1.5, kWidest = 14;
  constexpr std::size_t kFewestPoints = 64;  // fewer do not tell where a surface is
  // Seen from near a picture shows few points, and those around it tell.
  for (double part = kBesidePicture; part < kWidest; part *= kWider) {
    const auto within = static_cast<std::size_t>(std::ranges::count_if(beside, [&](double b) { return b <= part; }));
    if (within >= kFewestPoints) return part;
  }
  return {};
}

/// What a light sees of the tissue at rest, as far as it lies in the picture; nothing where the light is among it.
std::optional<LightWindow> window_of_tissue(const Matrix4& matrix, const SceneExtent& extent, const Camera& camera) {
  LightWindow whole, seen;
  std::vector<std::array<double, 4>> lit;
  for (const Vector3& point : extent.rest_points) {
    lit.push_back(clip_place(matrix, point));
    if (!(lit.back()[3] > 0)) return {};
    whole.add(lit.back());
  }
  if (whole.is_empty()) return {};
  const std::vector<double> beside = places_beside(extent, camera);
  const std::optional<double> part = part_to_light(beside);
  if (!part) return whole;
  std::size_t seen_points = 0;
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (beside[i] > *part) continue;
    seen.add(lit[i]);
    ++seen_points;
  }
  return seen.is_empty() ? whole : around_seen(whole, seen, seen_points);
}

/// Narrows a light's view to what the picture shows of the tissue at rest, and as much more as that has grown: the
/// shadow's raster is finer then, and stays still while the scene moves a little.
Matrix4 narrowed_to_tissue(const Matrix4& matrix, const SceneExtent& extent, const Camera& camera) {
  constexpr double kMargin = 1.15;
  const std::optional<LightWindow> window = window_of_tissue(matrix, extent, camera);
  if (!window) return matrix;
  const double grown = extent.reach / (0.5 * extent.size);
  Matrix4 result = matrix;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double middle = 0.5 * (window->low[axis] + window->high[axis]);
    const double half = std::clamp(0.5 * kMargin * grown * (window->high[axis] - window->low[axis]), 0.05, 1.0);
    const int row = static_cast<int>(axis);
    for (int column = 0; column < 4; ++column) {
      result(row, column) = (matrix(row, column) - middle * matrix(3, column)) / half;
    }
  }
  return result;
}

Matrix4 key_light_matrix(const SceneExtent& extent, const Studio& studio, const Camera& camera) {
  return narrowed_to_tissue(whole_light_matrix(extent, studio), extent, camera);
}

double shadow_map_pixels(const Matrix4& light_matrix, const SceneExtent& extent, const Camera& camera, ImageSize size) {
  const auto growth = [&](int row) {  // of a clip coordinate, not divided, over metres
    return length(Vector3{light_matrix(row, 0), light_matrix(row, 1), light_matrix(row, 2)});
  };
  const double widest = 2 / std::min(growth(0), growth(1));
  const std::vector<double> beside = places_beside(extent, camera);
  // Between the points of a coarse wall a near picture shows none: the one beside it tells.
  const double part = beside.empty() ? 1 : std::max(1.0, *std::ranges::min_element(beside));
  double sum = 0;
  int seen = 0;
  for (std::size_t i = 0; i < beside.size(); ++i) {
    const double along = dot(extent.rest_points[i] - camera.position, camera.forward);
    const double lit = clip_place(light_matrix, extent.rest_points[i])[3];
    if (!(lit > 0) || !(along > 0) || beside[i] > part) continue;
    const double pixel = 2 * camera.tangent_y * along / size.height;
    sum += widest * lit / pixel;
    ++seen;
  }
  return seen > 0 ? sum / seen : 0;
}

int shadow_resolution(Tier tier, double pixels, bool is_lamp_small) {
  constexpr int kFinest = 2048;
  const double widest_texel = is_lamp_small ? 2 : 3;  // pixels
  int resolution = tier == Tier::kFinal ? 1024 : 512;
  while (resolution < kFinest && pixels > widest_texel * resolution) resolution *= 2;
  return resolution;
}

FrameUniforms frame_uniforms(const Camera& camera, const SceneExtent& extent, const ViewDefinition& view,
                             const Studio& studio, const std::vector<ToolRod>& rods, ImageSize size, Ground ground) {
  const Vector3 key = studio.key_direction;
  const double ground_z = ground_height(camera, extent, studio);
  const bool with_floor = view.look.floor && !extent.rest_points.empty() && camera.position.z > ground_z;
  FrameUniforms frame;
  frame.view_projection = float_matrix(camera.matrix());
  frame.shadow_matrix = float_matrix(texture_matrix() * key_light_matrix(extent, studio, camera));
  // Over the distance from a tool: that of the brighter middle of the lamp's box, see environment.glsl. All of it would
  // have some 0.12, and leave no shadow by which one sees how high a tool is.
  constexpr double kSpread = 0.07;
  frame.camera_position = float4(camera.position, kSpread * ToolCover::texels_over_depth(frame.shadow_matrix));
  frame.ray_middle = float4(camera.forward, 0);
  frame.ray_right = float4(camera.tangent_x * camera.right, 1.0 / size.width);
  frame.ray_up = float4(camera.tangent_y * camera.up, 1.0 / size.height);
  frame.scene_center = float4(extent.center, extent.size);
  frame.floor = {static_cast<float>(ground_z), with_floor ? 1.0f : 0.0f, static_cast<float>(2.0 * extent.reach),
                 static_cast<float>(camera.field_stop)};
  frame.key_direction = studio.lamp_place ? float4(*studio.lamp_place, lamp_strength(view.lights, camera, extent))
                                          : float4(key, view.lights.key);
  frame.key_right = float4(perpendicular(key), camera.kind == CameraKind::kEndoscope ? kLensDarkening : 0);
  const Vector3 front = turned(studio.front, -0.5);
  const Vector3 back = turned(studio.front, 2.0);
  frame.panels = {static_cast<float>(front.x), static_cast<float>(front.y), static_cast<float>(back.x),
                  static_cast<float>(back.y)};
  frame.fill_direction = float4(studio.fill_direction, view.lights.fill);
  frame.environment = {static_cast<float>(view.lights.environment),
                       static_cast<float>(view.lights.environment_contrast), static_cast<float>(0.006 * extent.size),
                       static_cast<float>(2 * camera.tangent_y / size.height)};
  for (std::size_t i = 0; i < 3; ++i) {
    frame.background[i] = static_cast<float>(view.look.background[i]);
  }
  frame.background[3] = static_cast<float>(std::exp2(view.camera.exposure));
  light_floor(frame, view, ground);
  frame.floor_key[3] = 1.0f / static_cast<float>(size.width);
  frame.floor_sky[3] = 1.0f / static_cast<float>(size.height);
  frame.tissue = mirrored_tissue(view.look);
  const std::size_t count = std::min(rods.size(), kMostRods);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 start = vector3(rods[i].start);
    const Vector3 span = vector3(rods[i].end) - start;
    const double squared = dot(span, span);
    frame.rod_start[i] = float4(start, static_cast<double>(rods[i].radius) * rods[i].radius);
    frame.rod_span[i] = float4(span, squared > 0 ? 1 / squared : 0);
  }
  return frame;
}

FrameUniforms sampled_off_middle(FrameUniforms frame, std::array<double, 2> shift, ImageSize size) {
  const std::array<int, 2> sides{size.width, size.height};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto clip = static_cast<float>(2 * shift[axis] / sides[axis]);
    frame.sample_shift[axis] = clip;
    // What was seen there comes to the middle.
    for (std::size_t column = 0; column < 4; ++column) {
      frame.view_projection[4 * column + axis] -= clip * frame.view_projection[4 * column + 3];
    }
  }
  return frame;
}

}  // namespace thinwall
