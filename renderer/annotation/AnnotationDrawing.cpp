#include "renderer/annotation/AnnotationDrawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "renderer/annotation/ArrowShape.hpp"
#include "renderer/annotation/ClearPlace.hpp"
#include "renderer/annotation/LabelLayout.hpp"
#include "renderer/annotation/LabelOrder.hpp"
#include "renderer/annotation/MaterialPoint.hpp"
#include "renderer/overlay/Font.hpp"
#include "renderer/overlay/NumberText.hpp"
#include "renderer/overlay/Plate.hpp"
#include "renderer/overlay/Text.hpp"
#include "renderer/picture/Camera.hpp"
#include "renderer/picture/ToolShape.hpp"

namespace thinwall {
namespace {

// Lengths in units of 1/720 of the picture's height.
constexpr double kTextSize = 17;
constexpr double kPadX = 11, kPadY = 6;
constexpr double kArrowWidth = 6;
constexpr double kWidestText = 230;
constexpr double kDotRadius = 4.5;
constexpr Color kDark{0.02, 0.03, 0.04, 0.55};
constexpr Color kForceColor{0.99, 0.80, 0.28};

/// What all annotations of a picture need.
struct Scene {
  const Snapshot& snapshot;
  const CameraDefinition& definition;
  SceneExtent extent;
  Camera camera;
  OverlayGrid grid;
  ImageSize size;            // of the part of the picture
  std::optional<Box> inset;  // of another picture, in this part
  std::vector<Box> taken;    // by a legend and captions, in this part
  std::vector<ToolShape> tools = {};

  std::optional<PixelPoint> pixel(Vector3 place) const { return camera.pixel(place, size); }

  /// Whether a place lies in the picture, within the field stop of an endoscope, and not under an inset.
  bool shows(PixelPoint at) const {
    if (inset && at[0] > inset->x && at[0] < inset->right() && at[1] > inset->y && at[1] < inset->bottom())
      return false;
    const double x = (2 * at[0] / size.width - 1) * camera.tangent_x;
    const double y = (2 * at[1] / size.height - 1) * camera.tangent_y;
    if (camera.field_stop > 0 && std::hypot(x, y) > camera.field_stop) return false;
    return std::abs(x) <= camera.tangent_x && std::abs(y) <= camera.tangent_y;
  }
};

const SnapshotSurface* find_surface(const Snapshot& snapshot, const std::string& body) {
  const auto found = std::ranges::find(snapshot.surfaces, body, &SnapshotSurface::body);
  return found == snapshot.surfaces.end() ? nullptr : &*found;
}

std::optional<Vector3> material_place(const Snapshot& snapshot, const std::string& body, const Double3& at) {
  const SnapshotSurface* surface = find_surface(snapshot, body);
  if (surface == nullptr) return std::nullopt;
  const std::optional<MaterialPoint> point = nearest_material_point(*surface->topology, at);
  return point ? std::optional(place_of(*point, *surface)) : std::nullopt;
}

/// Outlines of tools: vertices and points along their rods.
std::vector<PixelPoint> tool_obstacles(const Scene& scene, const std::vector<ToolShape>& tools) {
  std::vector<PixelPoint> obstacles;
  const auto add = [&](Vector3 place) {
    const std::optional<PixelPoint> at = scene.pixel(place);
    if (at && scene.shows(*at)) obstacles.push_back(*at);
  };
  constexpr int kAlongRods = 64;
  for (const ToolShape& shape : tools) {
    for (const ToolVertex& vertex : shape.vertices) add(vector3(vertex.position));
    for (const ToolRod& rod : shape.rods) {
      const Vector3 start = vector3(rod.start), span = vector3(rod.end) - start;
      for (int i = 0; i <= kAlongRods; ++i) add(start + (static_cast<double>(i) / kAlongRods) * span);
    }
  }
  return obstacles;
}

/// Vertices of the surfaces.
std::vector<PixelPoint> wall_obstacles(const Scene& scene) {
  std::vector<PixelPoint> obstacles;
  for (const SnapshotSurface& surface : scene.snapshot.surfaces) {
    for (const Float3& position : surface.positions) {
      const std::optional<PixelPoint> at = scene.pixel(vector3(position));
      if (at && scene.shows(*at)) obstacles.push_back(*at);
    }
  }
  return obstacles;
}

/// Where the camera is at `time`, but for a point that it follows and walls that grow: decides sides and order once for
/// all.
Camera resting_camera_at(const Scene& scene, double time) {
  CameraDefinition camera = scene.definition;
  camera.followed_point.reset();
  SceneExtent extent = scene.extent;
  extent.grown_points.clear();
  return resolve_camera(camera, extent, scene.size, time);
}

/// Whether a place, at rest, lies left of the middle of the organs when it is first shown.
bool is_left_of_middle(const Scene& scene, const Double3& at, double first_shown) {
  const Camera first = resting_camera_at(scene, first_shown);
  const auto place = first.pixel(vector3(at), scene.size), middle = first.pixel(scene.extent.center, scene.size);
  return (place ? (*place)[0] : 0) < (middle ? (*middle)[0] : 0.5 * scene.size.width);
}

/// Whether the words at an arrow's tail stand left of it, beyond its tail rather than along its shaft, as it is at rest
/// when it is first shown; those of an arrow that goes upwards or downwards, where labels of its point would.
bool has_words_on_the_left(const Scene& scene, const ArrowDefinition& arrow) {
  const Camera first = resting_camera_at(scene, arrow.span.begin);
  const Vector3 at = vector3(arrow.at);
  const auto tip = first.pixel(at, scene.size);
  const auto tail = first.pixel(at - arrow.length * vector3(arrow.direction), scene.size);
  if (!tip || !tail) return false;
  const double across = (*tip)[0] - (*tail)[0], down = (*tip)[1] - (*tail)[1];
  if (std::abs(across) > std::abs(down)) return across > 0;
  return is_left_of_middle(scene, arrow.at, arrow.span.begin);
}

/// Between title and panels, and above captions that stand above these.
Box label_bounds(const Scene& scene) {
  const double margin = scene.grid.pixels(plate_style::kMargin);
  const double top = margin + scene.grid.pixels(52);
  const double bottom = scene.size.height - height_of_panels_and_captions(scene.grid) - scene.grid.pixels(12);
  return {margin, top, std::max(1.0, scene.size.width - 2 * margin), std::max(1.0, bottom - top)};
}

/// Whether a place, at rest, lies in the lower half of where labels may be when it is first shown.
bool is_low(const Scene& scene, const Double3& at, double first_shown) {
  const auto place = resting_camera_at(scene, first_shown).pixel(vector3(at), scene.size);
  const Box bounds = label_bounds(scene);
  return place && (*place)[1] > bounds.y + 0.5 * bounds.height;
}

/// The outline of the walls at rest. Rows of it are not higher than labels.
std::vector<PixelPoint> resting_outline(const Scene& scene, const Camera& camera) {
  std::vector<PixelPoint> points;
  for (const SnapshotSurface& surface : scene.snapshot.surfaces) {
    for (const Float3& position : surface.topology->rest_positions) {
      if (const auto at = camera.pixel(vector3(position), scene.size)) points.push_back(*at);
    }
  }
  return outline_of(points, scene.grid.pixels(8));
}

LabelRoom empty_room(const Scene& scene) {
  return {.bounds = label_bounds(scene), .gap = scene.grid.pixels(8), .distance = scene.grid.pixels(26)};
}

struct ShownLabel {
  const LabelDefinition* definition = nullptr;
  Text text;
  PixelPoint anchor = {};
  bool hidden = false;
  bool on_the_left = false;
  bool upwards = false;  // from its anchor, where it would cover it
  LabelPlace place = LabelPlace::kBeside;
};

LabelWish wish_of(const Scene& scene, const ShownLabel& label) {
  return {.anchor = label.anchor,
          .width = label.text.width() + 2 * scene.grid.pixels(kPadX),
          .height = label.text.height() + 2 * scene.grid.pixels(kPadY),
          .on_the_left = label.on_the_left,
          .upwards = label.upwards,
          .place = label.place};
}

/// Decides where labels stand to the walls as these are, at rest, when each is first shown.
void find_places(const Scene& scene, std::vector<ShownLabel>& labels) {
  std::map<double, LabelRoom> rooms;
  for (ShownLabel& label : labels) {
    const double begin = label.definition->span.begin;
    const Camera camera = resting_camera_at(scene, begin);
    const auto [found, is_new] = rooms.try_emplace(begin, empty_room(scene));
    LabelRoom& room = found->second;
    if (is_new) {
      room.obstacles = resting_outline(scene, camera);
      std::tie(room.walls_top, room.walls_bottom) = heights_of(room.obstacles);
    }
    LabelWish wish = wish_of(scene, label);
    wish.anchor = camera.pixel(vector3(label.definition->at), scene.size).value_or(label.anchor);
    label.place = roomy_place(wish, room);
  }
}

std::vector<ShownLabel> shown_labels(const Scene& scene, const std::vector<LabelDefinition>& labels) {
  std::vector<ShownLabel> shown;
  for (const LabelDefinition& label : labels) {
    if (!label.span.holds(scene.snapshot.time)) continue;
    const std::optional<Vector3> place = material_place(scene.snapshot, label.body, label.at);
    const std::optional<PixelPoint> anchor = place ? scene.pixel(*place) : std::nullopt;
    if (!anchor || !scene.shows(*anchor)) continue;
    const TextStyle style{.size = scene.grid.pixels(kTextSize), .bold = true, .color = plate_style::kText};
    const bool is_left = label.side == LabelSide::kNearest ? is_left_of_middle(scene, label.at, label.span.begin)
                                                           : label.side == LabelSide::kLeft;
    shown.push_back({.definition = &label,
                     .text = Text(label.text, style, {.width = scene.grid.pixels(kWidestText), .lines = 3}),
                     .anchor = *anchor,
                     .hidden = is_hidden(*place, scene.camera.position, scene.snapshot, scene.tools),
                     .on_the_left = is_left,
                     .upwards = is_low(scene, label.at, label.span.begin)});
  }
  find_places(scene, shown);
  return shown;
}

void draw_leader(const Canvas& canvas, const Scene& scene, const ShownLabel& label, const Leader& leader) {
  const auto [x, y] = leader.from;
  const auto [to_x, to_y] = leader.to;
  const double line = std::max(1.0, scene.grid.pixels(1.8));
  const double dot = scene.grid.pixels(kDotRadius);
  canvas.line(x, y, to_x, to_y, 2.4 * line, kDark);
  canvas.fill_circle(to_x, to_y, dot + line, kDark);
  canvas.line(x, y, to_x, to_y, line, label.hidden ? plate_style::kFaintText : plate_style::kText);
  canvas.fill_circle(to_x, to_y, dot, label.hidden ? plate_style::kFaintText : plate_style::kText);
  if (label.hidden) canvas.fill_circle(to_x, to_y, 0.6 * dot, {0.1, 0.1, 0.1});
}

void draw_plate(const Canvas& canvas, const Scene& scene, const Text& text, const Box& box) {
  const double radius = scene.grid.pixels(7);
  canvas.fill_rounded(box, radius, plate_style::kFill.with_opacity(0.82));
  text.draw(canvas, box.x + 0.5 * (box.width - text.width()), box.y + 0.5 * (box.height - text.height()));
}

std::vector<LabelWish> wishes_of(const Scene& scene, const std::vector<ShownLabel>& shown) {
  std::vector<LabelWish> wishes;
  for (const ShownLabel& label : shown) wishes.push_back(wish_of(scene, label));
  return wishes;
}

/// The same labels at times while they are shown together, pointing at the wall at rest.
std::vector<LabelMoment> moments_of(const Scene& scene, const std::vector<ShownLabel>& shown,
                                    const std::vector<LabelWish>& wishes) {
  constexpr int kMoments = 5;
  constexpr double kLongest = 10;  // seconds, of labels that stay to the end
  double begin = 0, end = std::numeric_limits<double>::infinity();
  for (const ShownLabel& label : shown) {
    begin = std::max(begin, label.definition->span.begin);
    end = std::min(end, label.definition->span.end);
  }
  end = std::clamp(end, begin, begin + kLongest);
  std::vector<LabelMoment> moments;
  for (int k = 0; k < kMoments; ++k) {
    const Camera camera = resting_camera_at(scene, begin + (end - begin) * k / (kMoments - 1));
    LabelMoment& moment = moments.emplace_back(LabelMoment{wishes, resting_outline(scene, camera)});
    for (std::size_t i = 0; i < shown.size(); ++i) {
      moment.wishes[i].anchor = camera.pixel(vector3(shown[i].definition->at), scene.size).value_or(PixelPoint{0, 0});
    }
  }
  return moments;
}

/// By an inset, a legend and captions.
std::vector<Box> taken_in(const Scene& scene) {
  std::vector<Box> taken = scene.taken;
  if (scene.inset) taken.insert(taken.begin(), *scene.inset);
  return taken;
}

/// What texts keep clear of where a label points at: its dot.
Box dot_of(const Scene& scene, PixelPoint anchor) {
  const double radius = scene.grid.pixels(kDotRadius);
  return {anchor[0] - radius, anchor[1] - radius, 2 * radius, 2 * radius};
}

/// Gives where plates and dots are.
std::vector<Box> draw_labels(const Canvas& canvas, const Scene& scene, const std::vector<LabelDefinition>& labels) {
  std::vector<ShownLabel> unordered = shown_labels(scene, labels);
  if (unordered.empty()) return {};
  LabelRoom room = empty_room(scene);
  room.obstacles = wall_obstacles(scene);
  std::tie(room.walls_top, room.walls_bottom) = heights_of(room.obstacles);
  room.tools = tool_obstacles(scene, scene.tools);
  room.obstacles.insert(room.obstacles.end(), room.tools.begin(), room.tools.end());
  room.taken = taken_in(scene);
  std::vector<ShownLabel> shown;
  for (const std::size_t i : order_of_labels(moments_of(scene, unordered, wishes_of(scene, unordered)), room)) {
    shown.push_back(std::move(unordered[i]));
  }
  const std::vector<LabelWish> wishes = wishes_of(scene, shown);
  std::vector<Box> boxes = lay_out_labels(wishes, room);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    draw_leader(canvas, scene, shown[i], leader_of(wishes[i], boxes[i]));
  }
  for (std::size_t i = 0; i < shown.size(); ++i) draw_plate(canvas, scene, shown[i].text, boxes[i]);
  for (const ShownLabel& label : shown) boxes.push_back(dot_of(scene, label.anchor));
  return boxes;
}

struct ArrowText {
  std::string words = {};
  PixelPoint end = {};  // of the arrow
  bool on_the_left = false;
  std::vector<ToolShape> tools = {};  // that it stands beside
};

/// Level with the arrow's end, beside it and its tools, clear of the plates, of which it becomes one.
void draw_arrow_text(const Canvas& canvas, const Scene& scene, const ArrowText& arrow, std::vector<Box>& plates) {
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
  const Box box = clear_place(lay_out_labels({wish}, room).front(), plates, room.gap, room.bounds);
  draw_plate(canvas, scene, text, box);
  plates.push_back(box);
}

/// Gives the texts, which come over all arrows and labels.
std::vector<ArrowText> draw_arrows(const Canvas& canvas, const Scene& scene,
                                   const std::vector<ArrowDefinition>& arrows) {
  std::vector<ArrowText> texts;
  for (const ArrowDefinition& arrow : arrows) {
    if (!arrow.span.holds(scene.snapshot.time)) continue;
    const std::optional<Vector3> place = material_place(scene.snapshot, arrow.body, arrow.at);
    if (!place) continue;
    const std::optional<PixelPoint> tip = scene.pixel(*place);
    const std::optional<PixelPoint> tail = scene.pixel(*place - arrow.length * vector3(arrow.direction));
    if (!tip || !tail || !scene.shows(*tip)) continue;
    draw_arrow(canvas, *tail, *tip, scene.grid.pixels(kArrowWidth), plate_style::kCurve);
    if (arrow.text.empty()) continue;
    texts.push_back({arrow.text, *tail, has_words_on_the_left(scene, arrow), scene.tools});
  }
  return texts;
}

/// The same.
std::vector<ArrowText> draw_force_arrows(const Canvas& canvas, const Scene& scene,
                                         const std::vector<ForceArrowDefinition>& arrows) {
  std::vector<ArrowText> texts;
  for (const ForceArrowDefinition& arrow : arrows) {
    const auto tool = std::ranges::find(scene.snapshot.tools, arrow.tool, &SnapshotTool::name);
    if (tool == scene.snapshot.tools.end() || !arrow.span.holds(scene.snapshot.time)) continue;
    const Vector3 force = vector3(tool->force);
    const std::optional<PixelPoint> tail = scene.pixel(vector3(tool->tip));
    const std::optional<PixelPoint> tip = scene.pixel(vector3(tool->tip) + (arrow.length / arrow.full) * force);
    if (!tail || !tip || !scene.shows(*tail)) continue;
    // An arrow that grows from nothing has words once it is an arrow.
    const double least = scene.grid.pixels(10), width = scene.grid.pixels(kArrowWidth);
    const Vector3 way = (arrow.length / arrow.full) * force, from = vector3(tool->tip) - scene.camera.position;
    const double pixel = 2 * scene.camera.tangent_y * dot(from, scene.camera.forward) / scene.size.height;
    if (length(way) < least * pixel) continue;
    if (std::hypot((*tip)[0] - (*tail)[0], (*tip)[1] - (*tail)[1]) >= least) {
      draw_arrow(canvas, *tail, *tip, width, kForceColor);
    } else {
      draw_arrow_end_on(canvas, *tail, width, dot(way, from) < 0, kForceColor);
    }
    // Beyond another tool its number would be read as that one's force.
    texts.push_back({.words = force_quantity(length(force), arrow.full, arrow.full).text(),
                     .end = *tip,
                     .tools = {tool_shape(*tool, scene.extent.size)}});
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

void draw_annotations(Image& image, const PictureBox& box, const AnnotationDefinition& annotations,
                      const Snapshot& snapshot, const CameraDefinition& camera, const std::optional<PictureBox>& inset,
                      const std::vector<Box>& taken) {
  if (annotations.is_empty()) return;
  const FontUse use;
  const SceneExtent extent = scene_extent(snapshot);
  Scene scene{.snapshot = snapshot,
              .definition = camera,
              .extent = extent,
              .camera = resolve_camera(camera, extent, box.size, snapshot.time),
              .grid = OverlayGrid(image.size),
              .size = box.size,
              .inset = place_within(box, box_of(inset)),
              .taken = {}};
  for (const Box& place : taken) {
    if (const std::optional<Box> within = place_within(box, place)) scene.taken.push_back(*within);
  }
  for (const SnapshotTool& tool : snapshot.tools) {
    if (!tool.is_set_aside) scene.tools.push_back(tool_shape(tool, extent.size));
  }
  const Canvas canvas(box.size);
  if (scene.inset) keep_off(canvas, box.size, *scene.inset);
  const std::vector<ArrowText> texts = draw_arrows(canvas, scene, annotations.arrows);
  const std::vector<ArrowText> forces = draw_force_arrows(canvas, scene, annotations.force_arrows);
  std::vector<Box> plates = draw_labels(canvas, scene, annotations.labels);
  for (const Box& place : taken_in(scene)) plates.push_back(place);
  for (const ArrowText& text : texts) draw_arrow_text(canvas, scene, text, plates);
  for (const ArrowText& force : forces) draw_arrow_text(canvas, scene, force, plates);
  canvas.blend_onto(image, box.left, box.top);
}

}  // namespace thinwall
