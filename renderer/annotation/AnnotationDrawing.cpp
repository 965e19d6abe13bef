#include "renderer/annotation/AnnotationDrawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/annotation/AnnotationScene.hpp"
#include "renderer/annotation/ArrowShape.hpp"
#include "renderer/annotation/ClearPlace.hpp"
#include "renderer/annotation/LabelDrawing.hpp"
#include "renderer/overlay/Font.hpp"
#include "renderer/overlay/NumberText.hpp"

namespace thinwall {
namespace {

using namespace annotation_style;

constexpr double kArrowWidth = 6;  // in units of 1/720 of the picture's height
constexpr Color kForceColor{0.99, 0.80, 0.28};

/// Whether the words at an arrow's tail stand left of it, beyond its tail rather than along its shaft, as it is at rest
/// when it is first shown; those of an arrow that goes upwards or downwards, where labels of its point would.
bool has_words_on_the_left(const AnnotationScene& scene, const ArrowDefinition& arrow, Vector3 at_rest) {
  const Camera first = resting_camera_at(scene, arrow.span.begin);
  const auto tip = first.pixel(at_rest, scene.size);
  const auto tail = first.pixel(at_rest - arrow.length * vector3(arrow.direction), scene.size);
  if (!tip || !tail) return false;
  const double across = (*tip)[0] - (*tail)[0], down = (*tip)[1] - (*tail)[1];
  if (std::abs(across) > std::abs(down)) return across > 0;
  return is_left_of_middle(scene, at_rest, arrow.span.begin);
}

struct ArrowText {
  std::string words = {};
  PixelPoint end = {};  // of the arrow
  bool on_the_left = false;
  std::vector<ToolShape> tools = {};  // that it stands beside
  bool leaves_wounds_free = false;    // those of a force are read at the blade, where the wound is
};

/// The smallest box around both.
Box around(const Box& one, const Box& other) {
  const double x = std::min(one.x, other.x), y = std::min(one.y, other.y);
  return {x, y, std::max(one.right(), other.right()) - x, std::max(one.bottom(), other.bottom()) - y};
}

/// Around the lips of cuts that lie nearer to a box than it is high; nothing where none do.
std::optional<Box> wound_near(const AnnotationScene& scene, const Box& box) {
  const double reach = box.height;
  std::optional<Box> found;
  for (const SnapshotSurface& surface : scene.snapshot.surfaces) {
    const std::vector<float>& cut_times = surface.topology->cut_times;
    for (std::size_t vertex = 0; vertex < cut_times.size(); ++vertex) {
      if (cut_times[vertex] == kNeverCut) continue;
      const std::optional<PixelPoint> at = scene.pixel(vector3(surface.positions[vertex]));
      if (!at || !scene.shows(*at)) continue;
      const auto [x, y] = *at;
      if (x < box.x - reach || x > box.right() + reach || y < box.y - reach || y > box.bottom() + reach) continue;
      found = around(found.value_or(Box{x, y}), Box{x, y});
    }
  }
  return found;
}

/// Level with the arrow's end, beside it and its tools, clear of the plates, of which it becomes one.
void draw_arrow_text(const Canvas& canvas, const AnnotationScene& scene, const ArrowText& arrow,
                     std::vector<Box>& plates) {
  const Text text(arrow.words, {.size = scene.grid.pixels(kTextSize), .bold = true, .color = plate_style::kText},
                  {.width = scene.grid.pixels(kWidestText), .lines = 2});
  const LabelWish wish{.anchor = arrow.end,
                       .width = text.width() + 2 * scene.grid.pixels(kPadX),
                       .height = text.height() + 2 * scene.grid.pixels(kPadY),
                       .on_the_left = arrow.on_the_left};
  LabelRoom room{.bounds = label_bounds(scene),
                 .obstacles = tool_obstacles(scene, arrow.tools),
                 .gap = scene.grid.pixels(6),
                 .distance = scene.grid.pixels(12)};
  room.obstacles.push_back(arrow.end);
  Box box = lay_out_labels({wish}, room).front();
  std::vector<Box> kept_clear = plates;
  if (const auto wound = arrow.leaves_wounds_free ? wound_near(scene, box) : std::nullopt) {
    kept_clear.push_back(*wound);
    // At the height where it leaves that free it stands beside the tools again.
    LabelWish clear = wish;
    clear.anchor[1] = clear_place(box, {*wound}, room.gap, room.bounds).y + 0.5 * box.height;
    box = lay_out_labels({clear}, room).front();
  }
  box = clear_place(box, kept_clear, room.gap, room.bounds);
  draw_plate(canvas, scene, text, box);
  plates.push_back(box);
}

/// Gives the texts, which come over all arrows and labels.
std::vector<ArrowText> draw_arrows(const Canvas& canvas, const AnnotationScene& scene,
                                   const std::vector<ArrowDefinition>& arrows) {
  std::vector<ArrowText> texts;
  for (const ArrowDefinition& arrow : arrows) {
    if (!arrow.span.holds(scene.snapshot.time)) continue;
    const std::optional<MaterialPlace> place = material_place(scene.snapshot, arrow.body, arrow.at);
    if (!place) continue;
    const std::optional<PixelPoint> tip = scene.pixel(place->now);
    const std::optional<PixelPoint> tail = scene.pixel(place->now - arrow.length * vector3(arrow.direction));
    if (!tip || !tail || !scene.shows(*tip)) continue;
    draw_arrow(canvas, *tail, *tip, scene.grid.pixels(kArrowWidth), plate_style::kCurve);
    if (arrow.text.empty()) continue;
    texts.push_back({arrow.text, *tail, has_words_on_the_left(scene, arrow, place->at_rest), scene.tools, true});
  }
  return texts;
}

// Of a force arrow, in units of 1/720 of the picture's height: one that grows from nothing has words once it is an
// arrow.
constexpr double kShortestForceArrow = 10;

/// From the tool's tip, metres.
Vector3 force_way(const ForceArrowDefinition& arrow, const SnapshotTool& tool) {
  return (arrow.length / arrow.full) * vector3(tool.force);
}

/// Seen from its side.
bool is_long_enough(const ForceArrowDefinition& arrow, const SnapshotTool& tool, const AnnotationScene& scene) {
  const Vector3 from = vector3(tool.tip) - scene.camera.position;
  const double pixel = 2 * scene.camera.tangent_y * dot(from, scene.camera.forward) / scene.size.height;
  return length(force_way(arrow, tool)) >= scene.grid.pixels(kShortestForceArrow) * pixel;
}

/// The same.
std::vector<ArrowText> draw_force_arrows(const Canvas& canvas, const AnnotationScene& scene,
                                         const std::vector<ForceArrowDefinition>& arrows) {
  std::vector<ArrowText> texts;
  for (const ForceArrowDefinition& arrow : arrows) {
    const auto tool = std::ranges::find(scene.snapshot.tools, arrow.tool, &SnapshotTool::name);
    if (tool == scene.snapshot.tools.end() || !arrow.span.holds(scene.snapshot.time)) continue;
    const Vector3 way = force_way(arrow, *tool);
    const std::optional<PixelPoint> tail = scene.pixel(vector3(tool->tip));
    const std::optional<PixelPoint> tip = scene.pixel(vector3(tool->tip) + way);
    if (!tail || !tip || !scene.shows(*tail) || !is_long_enough(arrow, *tool, scene)) continue;
    const double least = scene.grid.pixels(kShortestForceArrow), width = scene.grid.pixels(kArrowWidth);
    if (std::hypot((*tip)[0] - (*tail)[0], (*tip)[1] - (*tail)[1]) >= least) {
      draw_arrow(canvas, *tail, *tip, width, kForceColor);
    } else {
      const bool comes_nearer = dot(way, vector3(tool->tip) - scene.camera.position) < 0;
      draw_arrow_end_on(canvas, *tail, width, comes_nearer, kForceColor);
    }
    // Beyond another tool its number would be read as that one's force.
    texts.push_back({.words = force_quantity(length(vector3(tool->force)), arrow.full, arrow.full).text(),
                     .end = *tip,
                     .tools = {tool_shape(*tool, scene.extent.subject().size)}});
  }
  return texts;
}

/// A place of the whole picture from the upper left of a part of it; none where it lies outside of the part.
std::optional<Box> place_within(const PictureBox& part, const std::optional<Box>& whole) {
  if (!whole) return std::nullopt;
  const Box place{whole->x - part.left, whole->y - part.top, whole->width, whole->height};
  const bool is_outside =
      place.right() <= 0 || place.bottom() <= 0 || place.x >= part.size.width || place.y >= part.size.height;
  return is_outside ? std::nullopt : std::optional(place);
}

std::optional<Box> box_of(const std::optional<PictureBox>& inset) {
  if (!inset) return std::nullopt;
  return Box{static_cast<double>(inset->left), static_cast<double>(inset->top), static_cast<double>(inset->size.width),
             static_cast<double>(inset->size.height)};
}

/// What is drawn from now on leaves `inset` as it is.
void keep_off(const Canvas& canvas, ImageSize size, const Box& inset) {
  cairo_rectangle(canvas.context(), 0, 0, size.width, size.height);
  cairo_rectangle(canvas.context(), inset.x, inset.y, inset.width, inset.height);
  cairo_set_fill_rule(canvas.context(), CAIRO_FILL_RULE_EVEN_ODD);
  cairo_clip(canvas.context());
  cairo_set_fill_rule(canvas.context(), CAIRO_FILL_RULE_WINDING);
}

}  // namespace

AnnotationLayers::AnnotationLayers(ImageSize size, const PictureBox& box, const AnnotationDefinition& annotations,
                                   const Snapshot& snapshot, const CameraDefinition& camera,
                                   const std::optional<PictureBox>& inset, const std::vector<Box>& taken)
    : box_(box), lines_(std::make_unique<Canvas>(box.size)), points_(std::make_unique<Canvas>(box.size)) {
  const FontUse use;
  const SceneExtent extent = scene_extent(snapshot);
  AnnotationScene scene{.snapshot = snapshot,
                        .definition = camera,
                        .extent = extent,
                        .camera = resolve_camera(camera, extent, box.size, snapshot.time),
                        .grid = OverlayGrid(size),
                        .size = box.size,
                        .inset = place_within(box, box_of(inset)),
                        .taken = {}};
  for (const Box& place : taken) {
    if (const std::optional<Box> within = place_within(box, place)) scene.taken.push_back(*within);
  }
  for (const SnapshotTool& tool : snapshot.tools) {
    if (!tool.is_set_aside) scene.tools.push_back(tool_shape(tool, extent.subject().size));
  }
  if (scene.inset) {
    keep_off(*lines_, box.size, *scene.inset);
    keep_off(*points_, box.size, *scene.inset);
  }
  const std::vector<ArrowText> texts = draw_arrows(*points_, scene, annotations.arrows);
  const std::vector<ArrowText> forces = draw_force_arrows(*points_, scene, annotations.force_arrows);
  std::vector<Box> plates = draw_labels(*lines_, *points_, scene, annotations.labels);
  for (const Box& place : taken_in(scene)) plates.push_back(place);
  for (const ArrowText& text : texts) draw_arrow_text(*points_, scene, text, plates);
  for (const ArrowText& force : forces) draw_arrow_text(*points_, scene, force, plates);
}

AnnotationLayers::~AnnotationLayers() = default;
AnnotationLayers::AnnotationLayers(AnnotationLayers&&) noexcept = default;

void AnnotationLayers::lay_lines(Image& image) const {
  lines_->blend_onto(image, box_.left, box_.top);
}

void AnnotationLayers::lay_points(Image& image) const {
  points_->blend_onto(image, box_.left, box_.top);
}

namespace {

/// A whole picture without tools, legends and captions that texts keep clear of.
AnnotationScene bare_scene(const Snapshot& snapshot, const CameraDefinition& camera, ImageSize size) {
  const SceneExtent extent = scene_extent(snapshot);
  return {.snapshot = snapshot,
          .definition = camera,
          .extent = extent,
          .camera = resolve_camera(camera, extent, size, snapshot.time),
          .grid = OverlayGrid(size),
          .size = size,
          .inset = std::nullopt,
          .taken = {}};
}

}  // namespace

bool shows_point_of(const LabelDefinition& label, const Snapshot& snapshot, const CameraDefinition& camera,
                    ImageSize size) {
  const std::optional<MaterialPlace> place = material_place(snapshot, label.body, label.at);
  if (!place) return false;
  const AnnotationScene scene = bare_scene(snapshot, camera, size);
  const std::optional<PixelPoint> pixel = scene.pixel(place->now);
  return pixel && scene.shows(*pixel);
}

std::optional<bool> shows_force_arrow(const ForceArrowDefinition& arrow, const Snapshot& snapshot,
                                      const CameraDefinition& camera, ImageSize size) {
  const auto tool = std::ranges::find(snapshot.tools, arrow.tool, &SnapshotTool::name);
  if (tool == snapshot.tools.end() || !tool->touches()) return std::nullopt;
  const AnnotationScene scene = bare_scene(snapshot, camera, size);
  const std::optional<PixelPoint> tail = scene.pixel(vector3(tool->tip));
  if (!tail || !scene.shows(*tail)) return std::nullopt;
  return is_long_enough(arrow, *tool, scene);
}

}  // namespace thinwall
