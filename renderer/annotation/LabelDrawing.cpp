#include "renderer/annotation/LabelDrawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "renderer/annotation/LabelOrder.hpp"
#include "renderer/annotation/MaterialPoint.hpp"

namespace thinwall {
namespace {

using namespace annotation_style;

constexpr double kDotRadius = 4.5;  // in units of 1/720 of the picture's height
constexpr Color kDark{0.02, 0.03, 0.04, 0.55};

/// Vertices of the surfaces.
std::vector<PixelPoint> wall_obstacles(const AnnotationScene& scene) {
  std::vector<PixelPoint> obstacles;
  for (const SnapshotSurface& surface : scene.snapshot.surfaces) {
    for (const Float3& position : surface.positions) {
      const std::optional<PixelPoint> at = scene.pixel(vector3(position));
      if (at && scene.shows(*at)) obstacles.push_back(*at);
    }
  }
  return obstacles;
}

/// Whether a place, at rest, lies in the lower half of where labels may be when it is first shown.
bool is_low(const AnnotationScene& scene, Vector3 at_rest, double first_shown) {
  const auto place = resting_camera_at(scene, first_shown).pixel(at_rest, scene.size);
  const Box bounds = label_bounds(scene);
  return place && (*place)[1] > bounds.y + 0.5 * bounds.height;
}

/// The outline of the walls at rest. Rows of it are not higher than labels.
std::vector<PixelPoint> resting_outline(const AnnotationScene& scene, const Camera& camera) {
  std::vector<PixelPoint> points;
  for (const SnapshotSurface& surface : scene.snapshot.surfaces) {
    for (const Float3& position : surface.topology->rest_positions) {
      if (const auto at = camera.pixel(vector3(position), scene.size)) points.push_back(*at);
    }
  }
  return outline_of(points, scene.grid.pixels(8));
}

LabelRoom empty_room(const AnnotationScene& scene) {
  return {.bounds = label_bounds(scene), .gap = scene.grid.pixels(8), .distance = scene.grid.pixels(26)};
}

struct ShownLabel {
  const LabelDefinition* definition = nullptr;
  Text text;
  Vector3 at_rest = {};  // on the stress-free wall, what it points at; metres
  PixelPoint anchor = {};
  bool hidden = false;
  bool on_the_left = false;
  bool upwards = false;  // from its anchor, where it would cover it
  LabelPlace place = LabelPlace::kBeside;
};

LabelWish wish_of(const AnnotationScene& scene, const ShownLabel& label) {
  return {.anchor = label.anchor,
          .width = label.text.width() + 2 * scene.grid.pixels(kPadX),
          .height = label.text.height() + 2 * scene.grid.pixels(kPadY),
          .on_the_left = label.on_the_left,
          .upwards = label.upwards,
          .place = label.place};
}

/// The line of a label that has its place to its point at rest.
Leader resting_leader(const LabelWish& wish, LabelRoom room, const Box& inset) {
  room.taken = {inset};
  return leader_of(wish, lay_out_labels({wish}, room).front());
}

/// Whether a label would lead under the small picture, which lies over all, from where it stands, and not from the
/// other side, from where its line would not be long either.
bool stands_better_opposite(const AnnotationScene& scene, const LabelWish& wish, const LabelRoom& room) {
  constexpr double kLongestWay = 0.5;  // of the bounds: a line would cross what is shown
  // Where a camera goes along with a tool nothing is where it is at rest.
  if (!scene.inset || scene.definition.follow) return false;
  if (!runs_through(resting_leader(wish, room, *scene.inset), *scene.inset)) return false;
  LabelWish other = wish;
  other.on_the_left = !wish.on_the_left;
  other.place = roomy_place(other, room);
  const Leader leader = resting_leader(other, room, *scene.inset);
  return std::abs(leader.to[0] - leader.from[0]) <= kLongestWay * room.bounds.width &&
         !runs_through(leader, *scene.inset);
}

/// Decides where labels stand to the walls as these are, at rest, when each is first shown; on the other side than the
/// nearest where their lines would not be seen from there.
void find_places(const AnnotationScene& scene, std::vector<ShownLabel>& labels) {
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
    wish.anchor = camera.pixel(label.at_rest, scene.size).value_or(label.anchor);
    wish.place = roomy_place(wish, room);
    if (label.definition->side == LabelSide::kNearest && stands_better_opposite(scene, wish, room)) {
      wish.on_the_left = label.on_the_left = !label.on_the_left;
      wish.place = roomy_place(wish, room);
    }
    label.place = wish.place;
  }
}

std::vector<ShownLabel> shown_labels(const AnnotationScene& scene, const std::vector<LabelDefinition>& labels) {
  std::vector<ShownLabel> shown;
  for (const LabelDefinition& label : labels) {
    if (!label.span.holds(scene.snapshot.time)) continue;
    const std::optional<MaterialPlace> place = material_place(scene.snapshot, label.body, label.at);
    const std::optional<PixelPoint> anchor = place ? scene.pixel(place->now) : std::nullopt;
    if (!anchor || !scene.shows(*anchor)) continue;
    const TextStyle style{.size = scene.grid.pixels(kTextSize), .bold = true, .color = plate_style::kText};
    const bool is_left = label.side == LabelSide::kNearest ? is_left_of_middle(scene, place->at_rest, label.span.begin)
                                                           : label.side == LabelSide::kLeft;
    shown.push_back({.definition = &label,
                     .text = Text(label.text, style, {.width = scene.grid.pixels(kWidestText), .lines = 3}),
                     .at_rest = place->at_rest,
                     .anchor = *anchor,
                     .hidden = is_hidden(place->now, scene.camera.position, scene.snapshot, scene.tools),
                     .on_the_left = is_left,
                     .upwards = is_low(scene, place->at_rest, label.span.begin)});
  }
  find_places(scene, shown);
  return shown;
}

Color line_color(const ShownLabel& label) {
  return label.hidden ? plate_style::kFaintText : plate_style::kText;
}

/// With the dark rim of its dot.
void draw_line(const Canvas& canvas, const AnnotationScene& scene, const ShownLabel& label, const Leader& leader) {
  const auto [x, y] = leader.from;
  const auto [to_x, to_y] = leader.to;
  const double line = std::max(1.0, scene.grid.pixels(1.8));
  canvas.line(x, y, to_x, to_y, 2.4 * line, kDark);
  canvas.fill_circle(to_x, to_y, scene.grid.pixels(kDotRadius) + line, kDark);
  canvas.line(x, y, to_x, to_y, line, line_color(label));
}

void draw_dot(const Canvas& canvas, const AnnotationScene& scene, const ShownLabel& label) {
  const auto [x, y] = label.anchor;
  const double dot = scene.grid.pixels(kDotRadius);
  canvas.fill_circle(x, y, dot, line_color(label));
  if (label.hidden) canvas.fill_circle(x, y, 0.6 * dot, {0.1, 0.1, 0.1});
}

std::vector<LabelWish> wishes_of(const AnnotationScene& scene, const std::vector<ShownLabel>& shown) {
  std::vector<LabelWish> wishes;
  for (const ShownLabel& label : shown) wishes.push_back(wish_of(scene, label));
  return wishes;
}

/// The same labels at times while they are shown together, pointing at the wall at rest.
std::vector<LabelMoment> moments_of(const AnnotationScene& scene, const std::vector<ShownLabel>& shown,
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
      moment.wishes[i].anchor = camera.pixel(shown[i].at_rest, scene.size).value_or(PixelPoint{0, 0});
    }
  }
  return moments;
}

/// What texts keep clear of where a label points at: its dot.
Box dot_of(const AnnotationScene& scene, PixelPoint anchor) {
  const double radius = scene.grid.pixels(kDotRadius);
  return {anchor[0] - radius, anchor[1] - radius, 2 * radius, 2 * radius};
}

}  // namespace

std::vector<Box> draw_labels(const Canvas& lines, const Canvas& canvas, const AnnotationScene& scene,
                             const std::vector<LabelDefinition>& labels) {
  std::vector<ShownLabel> unordered = shown_labels(scene, labels);
  if (unordered.empty()) return {};
  LabelRoom room = empty_room(scene);
  room.obstacles = wall_obstacles(scene);
  std::tie(room.walls_top, room.walls_bottom) = heights_of(room.obstacles);
  room.tools = tool_obstacles(scene, scene.tools);
  room.obstacles.insert(room.obstacles.end(), room.tools.begin(), room.tools.end());
  room.taken = taken_in(scene);
  const LabelArrangement arrangement = arrange_labels(moments_of(scene, unordered, wishes_of(scene, unordered)), room);
  std::vector<ShownLabel> shown;
  for (const std::size_t i : arrangement.order) {
    unordered[i].place = arrangement.places[i];
    shown.push_back(std::move(unordered[i]));
  }
  const std::vector<LabelWish> wishes = wishes_of(scene, shown);
  std::vector<Box> boxes = lay_out_labels(wishes, room);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    draw_line(lines, scene, shown[i], leader_of(wishes[i], boxes[i]));
    draw_dot(canvas, scene, shown[i]);
  }
  for (std::size_t i = 0; i < shown.size(); ++i) draw_plate(canvas, scene, shown[i].text, boxes[i]);
  for (const ShownLabel& label : shown) boxes.push_back(dot_of(scene, label.anchor));
  return boxes;
}

}  // namespace thinwall
