#include "renderer/picture/Renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/Magnification.hpp"
#include "renderer/camera/SceneExtent.hpp"
#include "renderer/camera/Upright.hpp"
#include "renderer/device/OffscreenContext.hpp"
#include "renderer/image/SensorNoise.hpp"
#include "renderer/picture/Exposure.hpp"
#include "renderer/picture/FilmPass.hpp"
#include "renderer/picture/FinePixels.hpp"
#include "renderer/picture/FloorShade.hpp"
#include "renderer/picture/FluidPass.hpp"
#include "renderer/picture/FocusPass.hpp"
#include "renderer/picture/FrameUniforms.hpp"
#include "renderer/picture/LensPass.hpp"
#include "renderer/picture/MeshLinePass.hpp"
#include "renderer/picture/OutlinePass.hpp"
#include "renderer/picture/PassClock.hpp"
#include "renderer/picture/PictureTarget.hpp"
#include "renderer/picture/SceneMeshes.hpp"
#include "renderer/picture/ScenePass.hpp"
#include "renderer/picture/SecondThread.hpp"
#include "renderer/picture/ShadowMap.hpp"
#include "renderer/picture/ToolShade.hpp"

namespace thinwall {
namespace {

/// What a picture shows, besides the frame's uniforms.
struct SceneView {
  const Snapshot& snapshot;
  const ViewDefinition& view;
  Vector3 eye;       // metres
  double pixel = 0;  // its height over the distance
  Surroundings surroundings = Surroundings::kStudio;
  Ground ground = Ground::kFloor;
  std::vector<OutlineSegment> outline = {};  // but for Tier::kDraft
  bool keeps_bare = false;                   // whether fluids are to be told from what lies below them
};

/// All that lives in the context, in the order in which it can be made.
struct Stage {
  Stage(ImageSize size, Tier drawn_tier)
      : tier(drawn_tier), target(size), shadow_map(tier == Tier::kDraft ? 1 : shadow_resolution(tier, 0, false)) {
    glNamedBufferStorage(frame_block.name(), sizeof(FrameUniforms), nullptr, GL_DYNAMIC_STORAGE_BIT);
  }

  Tier tier;
  SecondThread second;
  PictureTarget target;
  SceneMeshes meshes;
  ScenePass scene_pass;
  FilmPass film_pass;
  FluidPass fluid_pass;
  OutlinePass outline_pass;
  FocusPass focus_pass;
  LensPass lens_pass;
  MeshLinePass mesh_lines;
  FloorShade floor_shade;
  ShadowMap shadow_map;
  ToolShade tool_shade;
  Buffer frame_block = create_buffer();
  std::vector<std::uint8_t> bare;  // the picture without fluids; empty where there are none, and but for Tier::kFinal
  std::vector<std::uint8_t> picture;  // as drawn, with fine pixels; for Tier::kFinal alone
  std::vector<std::uint8_t> corners;  // of fine pixels; kept, as all three, for their memory

  void share(const PassClock& clock, const std::function<void()>& here, const std::function<void()>& beside);
  void draw_shadow_map(const SceneExtent& extent, const Studio& studio, const Camera& camera, PassClock& clock);
  void draw_shadows(const FrameUniforms& frame, const SceneExtent& extent, const Studio& studio, const Camera& camera,
                    bool is_lamp_large, PassClock& clock);
  void draw_backdrop(Ground ground, const FieldStop& stop, PassClock& clock);
  void close_field_stop(const FieldStop& stop);
  void lay_backdrop(const FrameUniforms& frame, bool has_tools, PassClock& clock);
  void draw_surface(const FrameUniforms& frame, PassClock& clock);
  void draw_scene(SceneView& scene, const FrameUniforms& frame, PassClock& clock);
  void draw_first(SceneView& scene, const FrameUniforms& frame, PassClock& clock);
  void draw_fluids(const SceneView& scene, PassClock& clock);
  void draw_fine_pixels(SceneView& scene, const FrameUniforms& frame);
  Image finish(const Camera& camera, const Camera& pinhole, PassClock& clock);
  ScreenArea outlined_area(const FrameUniforms& frame) const;
  ScreenArea sharp_area(const FrameUniforms& frame) const;
  bool has_fluids() const { return !meshes.films().empty() || !meshes.fluids().empty(); }
  void use(const FrameUniforms& frame) const { glNamedBufferSubData(frame_block.name(), 0, sizeof(frame), &frame); }
};

/// Both at once; one after the other where passes are timed, so that each is told its own time.
void Stage::share(const PassClock& clock, const std::function<void()>& here, const std::function<void()>& beside) {
  if (!clock.is_running()) return second.share(here, beside);
  here();
  beside();
}

void Stage::draw_shadow_map(const SceneExtent& extent, const Studio& studio, const Camera& camera, PassClock& clock) {
  if (tier != Tier::kDraft) {
    const Matrix4 light_matrix = key_light_matrix(extent, studio, camera);
    const double pixels = shadow_map_pixels(light_matrix, extent, camera, target.size());
    // A small lamp makes the shadows of tools as sharp as those of tissue.
    const bool is_lamp_small = studio.lamp_place.has_value();
    shadow_map.resize(shadow_resolution(tier, pixels, is_lamp_small));
    shadow_map.draw(meshes, light_matrix, is_lamp_small);
    glFlush();
  } else {
    shadow_map.clear();
  }
  clock.ends("shadow map");
}

/// The threads of a software driver begin once one of the processor's cores is idle: what the other makes without them
/// goes along with what is handed to them.
void Stage::draw_shadows(const FrameUniforms& frame, const SceneExtent& extent, const Studio& studio,
                         const Camera& camera, bool is_lamp_large, PassClock& clock) {
  const bool has_floor = tier != Tier::kDraft && frame.floor[1] > 0;
  const bool has_tools = tier != Tier::kDraft && is_lamp_large && !meshes.tool_vertices().empty();
  const auto draw_map = [&] {
    draw_shadow_map(extent, studio, camera, clock);
    if (has_tools) tool_shade.lay(meshes, frame);
    clock.ends("tools' shade");
  };
  const auto lay_floor = [&] {
    if (has_floor) floor_shade.lay(meshes, frame, studio.key_direction);
    clock.ends("floor's shade");
  };
  share(clock, draw_map, lay_floor);
  has_floor ? floor_shade.upload() : floor_shade.clear();
  has_tools ? tool_shade.upload() : tool_shade.clear();
}

FieldStop field_stop(const FrameUniforms& frame) {
  const auto size = [](const Float4& a) { return std::hypot(a[0], a[1], a[2]); };
  return {.tangent = frame.floor[3], .half_field = {size(frame.ray_right), size(frame.ray_up)}};
}

void Stage::draw_backdrop(Ground ground, const FieldStop& stop, PassClock& clock) {
  scene_pass.draw_ground(target, ground, stop);
  target.read_backdrop();
  clock.ends("floor");
}

void Stage::draw_fluids(const SceneView& scene, PassClock& clock) {
  if (!meshes.films().empty()) {
    film_pass.draw(meshes.films(), scene.surroundings);
    clock.ends("blood and run-off");
  }
  if (!meshes.fluids().empty()) {
    fluid_pass.draw(meshes.fluids(), scene.surroundings);
    clock.ends("fluid");
  }
}

/// Where depth was not taken over from another picture.
void Stage::close_field_stop(const FieldStop& stop) {
  target.clear_depth();
  if (!(stop.tangent > 0)) return;
  scene_pass.close_field_stop(target);
  target.keep_stop(stop);
}

/// Before tools are drawn, which mirror the tissue that has been.
void Stage::lay_backdrop(const FrameUniforms& frame, bool has_tools, PassClock& clock) {
  const FieldStop stop = field_stop(frame);
  target.lay_backdrop(stop);
  if (has_tools) target.keep_tissue_depth(meshes.tissue_area(frame.view_projection, target.size()), stop);
  clock.ends("backdrop");
}

/// What is seen of the tissue; depth and stencil tell where, and tools mirror it. It does not touch the colours, so
/// that these can be filled while the driver's threads work on it.
void Stage::draw_surface(const FrameUniforms& frame, PassClock& clock) {
  scene_pass.draw_surface(meshes, target, frame.view_projection);
  glFlush();
  clock.ends("surface");
}

/// All pixels that show something of what has outlines.
ScreenArea Stage::outlined_area(const FrameUniforms& frame) const {
  return around(meshes.tissue_area(frame.view_projection, target.size()),
                meshes.tool_area(frame.view_projection, target.size()));
}

/// All pixels that may be fine: the backdrop is smooth, but for the field stop's border.
ScreenArea Stage::sharp_area(const FrameUniforms& frame) const {
  const bool is_everywhere = field_stop(frame).tangent > 0 || has_fluids();
  return is_everywhere ? target.whole() : outlined_area(frame);
}

/// What all else is drawn over, beside what the processor makes without the driver.
void Stage::draw_first(SceneView& scene, const FrameUniforms& frame, PassClock& clock) {
  const auto draw = [&] {
    draw_surface(frame, clock);
    lay_backdrop(frame, !scene.snapshot.tools.empty(), clock);
  };
  share(clock, draw, [&] {
    if (tier != Tier::kDraft) scene.outline = meshes.outline(scene.eye, scene.pixel);
    clock.ends("outline");
  });
}

/// Over the backdrop, all that is seen with the surface.
void Stage::draw_scene(SceneView& scene, const FrameUniforms& frame, PassClock& clock) {
  if (scene.ground == Ground::kDrape) {
    scene_pass.draw_weave(target);
    clock.ends("weave");
  }
  shadow_map.bind();
  scene_pass.draw_tools(meshes, target, frame.view_projection, scene.surroundings);
  clock.ends("tools");
  if (scene.view.look.data) {
    scene_pass.shade_data(target, scene.view.look.data->scale);
  } else {
    scene_pass.shade_tissue(meshes, target, frame, scene.surroundings, tier != Tier::kDraft);
    scene_pass.mark(meshes, scene.view.highlights, scene.snapshot.time);
  }
  clock.ends("tissue");
  if (scene.keeps_bare) target.read_color(has_fluids() ? target.whole() : ScreenArea{}, bare);
  draw_fluids(scene, clock);
  const LookDefinition& look = scene.view.look;
  if (look.mesh || look.data) {
    // Closed lips have the numbers of the wall beside them, so that of a cut nothing else is seen in them.
    mesh_lines.draw(look.mesh ? meshes.mesh_lines() : meshes.cut_lines());
    clock.ends("mesh lines");
  }
  if (tier != Tier::kDraft) outline_pass.draw(scene.outline, target);
  clock.ends("smoothed outline");
}

/// Draws the scene again for the corners of the pixels whose middles are not enough. Elsewhere the picture stays, so
/// that what is seen of a pixel's neighbour is there.
void Stage::draw_fine_pixels(SceneView& scene, const FrameUniforms& frame) {
  const ImageSize size = target.size();
  target.read_color(target.whole(), picture);
  const ScreenArea sharp = sharp_area(frame);
  if (sharp.width == 0 || sharp.height == 0) return;
  const FinePixels fine = find_fine_pixels(picture, bare, size.width, sharp);
  if (fine.is_fine.empty()) return;
  const FrameUniforms shifted = sampled_off_middle(frame, {0.5, 0.5}, size);
  use(shifted);
  target.write_color(fine.area, with_backdrop(fine, picture, target.backdrop(), size.width));
  target.clear_depth(fine);
  PassClock untimed(nullptr);
  draw_surface(shifted, untimed);
  scene.keeps_bare = false;
  draw_scene(scene, shifted, untimed);
  target.read_color(fine.area, corners);
  add_corners(fine, corners, picture, size.width);
}

Image Stage::finish(const Camera& camera, const Camera& pinhole, PassClock& clock) {
  const bool has_focus = camera.aperture > 0 && tier != Tier::kDraft;
  const bool is_distorted = camera.lens.distortion() != LensDistortion{};
  if (tier == Tier::kFinal) {
    if (!has_focus && !is_distorted) return target.finish(picture);
    target.write_color(target.whole(), picture);
  }
  if (has_focus) {
    focus_pass.draw(target, pinhole);
    clock.ends("focus");
  }
  if (is_distorted) {
    lens_pass.draw(target, camera, pinhole);
    clock.ends("lens");
  }
  return target.finish(is_distorted);
}

/// What tells the noise of one moment from that of another: its nanoseconds.
std::uint64_t moment_of(const Snapshot& snapshot) {
  return static_cast<std::uint64_t>(std::llround(1e9 * snapshot.time));
}

/// What lies below a scene in the open; a drape comes as near as what lies on it lets it.
Ground lay_ground(const Snapshot& snapshot, const LookDefinition& look, const SceneMeshes& meshes,
                  SceneExtent& extent) {
  const Ground ground = ground_below(look, meshes.has_sheet());
  if (ground == Ground::kDrape && !snapshot.surfaces.empty()) {
    extent.floor_height = lying_height(snapshot, meshes.ends());
  }
  return ground;
}

}  // namespace

struct Renderer::Implementation {
  Implementation(const DeviceChoice& device, ImageSize size, Tier tier) : context(device) {
    const CurrentContext current(context);
    stage.emplace(size, tier);
  }
  ~Implementation() {
    const CurrentContext current(context);
    stage.reset();
  }

  Image draw(const Snapshot& snapshot, const ViewDefinition& view, const CameraDefinition& seen_by,
             std::vector<PassTime>* times) {
    const double factor = magnification_of(snapshot);
    if (factor == 1) return draw_as_it_is(snapshot, view, seen_by, times);
    return draw_as_it_is(magnifier.magnified(snapshot, factor), magnified(view, factor), magnified(seen_by, factor),
                         times);
  }

  Image draw_as_it_is(const Snapshot& snapshot, const ViewDefinition& view, const CameraDefinition& seen_by,
                      std::vector<PassTime>* times);
  Image draw_upright(const Snapshot& snapshot, const SeenScene& seen, PassClock& clock);

  OffscreenContext context;
  std::optional<Stage> stage;
  Magnifier magnifier;
  Turner turner;
};

Image Renderer::Implementation::draw_as_it_is(const Snapshot& snapshot, const ViewDefinition& view,
                                              const CameraDefinition& seen_by, std::vector<PassTime>* times) {
  PassClock clock(times);
  const SeenScene seen = seen_scene(snapshot, view, seen_by, stage->target.size());
  const std::optional<Turn> turn = turn_upright(snapshot.gravity);
  if (!turn) return draw_upright(snapshot, seen, clock);
  const Snapshot upright = turner.turned(snapshot, *turn);
  return draw_upright(upright, turned(seen, upright, *turn), clock);
}

Image Renderer::Implementation::draw_upright(const Snapshot& snapshot, const SeenScene& seen, PassClock& clock) {
  const auto& [view, whole, camera, resting] = seen;
  SceneExtent extent = whole;
  const Camera pinhole = behind_the_lens(camera);
  const bool is_inside = seen.is_inside();
  const Studio studio = is_inside ? arrange_endoscope(camera, extent) : arrange_studio(view.lights, resting);
  const Surroundings surroundings = is_inside ? Surroundings::kCavity : Surroundings::kStudio;

  const CurrentContext current(context);
  stage->meshes.upload(snapshot, extent, view.look, camera.position, stage->second);
  const Ground ground = is_inside ? Ground::kTissue : lay_ground(snapshot, view.look, stage->meshes, extent);
  FrameUniforms frame =
      frame_uniforms(pinhole, extent, view, studio, stage->meshes.rods(), stage->target.size(), ground);
  if (view.camera.auto_exposure) {
    frame.background[3] *= static_cast<float>(std::exp2(metered_exposure(snapshot, view, pinhole, frame, is_inside)));
  }
  frame.rest_grid = stage->meshes.rest_grid();
  stage->use(frame);
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, stage->frame_block.name());

  clock.ends("meshes");
  stage->draw_shadows(frame, extent, studio, pinhole, !is_inside, clock);
  const bool is_stop_closed = stage->target.clear_depth(field_stop(frame));
  stage->draw_backdrop(ground, field_stop(frame), clock);
  if (!is_stop_closed) stage->close_field_stop(field_stop(frame));
  SceneView shown{.snapshot = snapshot, .view = view, .eye = camera.position, .surroundings = surroundings};
  shown.pixel = frame.environment[3];
  stage->draw_first(shown, frame, clock);
  shown.keeps_bare = stage->tier == Tier::kFinal;
  if (frame.floor[1] > 0) shown.ground = ground;
  stage->draw_scene(shown, frame, clock);
  if (stage->tier == Tier::kFinal) {
    if (camera.aperture > 0) stage->target.keep_depth();
    stage->draw_fine_pixels(shown, frame);
    clock.ends("fine pixels");
  }
  Image image = stage->finish(camera, pinhole, clock);
  if (view.camera.noise > 0) add_sensor_noise(image, view.camera.noise, view.camera.seed, moment_of(snapshot));
  clock.ends("read-back");
  return image;
}

Renderer::Renderer(const DeviceChoice& device, ImageSize size, Tier tier)
    : implementation_(std::make_unique<Implementation>(device, size, tier)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Image Renderer::draw(const Snapshot& snapshot, const ViewDefinition& view) {
  return implementation_->draw(snapshot, view, view.camera, nullptr);
}

Image Renderer::draw(const Snapshot& snapshot, const ViewDefinition& view, const CameraDefinition& camera) {
  return implementation_->draw(snapshot, view, camera, nullptr);
}

Image Renderer::draw_timed(const Snapshot& snapshot, const ViewDefinition& view, std::vector<PassTime>& times) {
  return draw_timed(snapshot, view, view.camera, times);
}

Image Renderer::draw_timed(const Snapshot& snapshot, const ViewDefinition& view, const CameraDefinition& camera,
                           std::vector<PassTime>& times) {
  return implementation_->draw(snapshot, view, camera, &times);
}

std::string Renderer::driver() const {
  return implementation_->context.driver();
}

}  // namespace thinwall
