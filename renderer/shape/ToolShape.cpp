#include "renderer/shape/ToolShape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/shape/ScalpelShape.hpp"
#include "renderer/shape/ToolBuilder.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {
namespace {

#include "renderer/picture/shaders/tool_rings.glsl"

/// Part of a circle around `center_back` on the middle line, from angle `from` to `to` (0 at the tip, pi at the back).
void append_arc(std::vector<OutlinePoint>& outline, double center_back, double radius, double from, double to,
                float roughness, int steps) {
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    outline.push_back({.back = center_back - radius * std::cos(angle),
                       .out = radius * std::sin(angle),
                       .normal_back = -std::cos(angle),
                       .normal_out = std::sin(angle),
                       .roughness = roughness});
  }
}

/// A smooth widening or narrowing from the outline's last point to (`back`, `out`).
void append_taper(std::vector<OutlinePoint>& outline, double back, double out, int steps) {
  const OutlinePoint from = outline.back();
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double slope = 6 * t * (1 - t) * (out - from.out) / (back - from.back);
    outline.push_back({.back = from.back + t * (back - from.back),
                       .out = from.out + t * t * (3 - 2 * t) * (out - from.out),
                       .normal_back = -slope,
                       .normal_out = 1});
  }
}

/// From the end of an arc around to a shaft of radius `out`, along a parabola that touches both.
void append_fillet(std::vector<OutlinePoint>& outline, double out) {
  constexpr int kSteps = 8;
  const OutlinePoint from = outline.back();
  if (!(from.normal_back > 0) || !(from.out > out)) return;
  // The arc's tangent reaches the shaft at `corner`; the parabola ends as far beyond.
  const double run = (from.out - out) * from.normal_out / from.normal_back;
  const double corner = from.back + run;
  const double end = corner + std::hypot(run, from.out - out);
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    const double slope_back = (1 - t) * run + t * (end - corner);
    const double slope_out = (1 - t) * (out - from.out);
    outline.push_back({.back = (1 - t) * (1 - t) * from.back + 2 * t * (1 - t) * corner + t * t * end,
                       .out = out + (1 - t) * (1 - t) * (from.out - out),
                       .normal_back = -slope_out,
                       .normal_out = slope_back,
                       .roughness = kPolished + static_cast<float>(t) * (kBrushed - kPolished)});
  }
}

/// From the outline's last point: slim shaft, widening, handle with rings, rounded end.
void append_shaft(std::vector<OutlinePoint>& outline, double slim, double thick, double scene_size) {
  const double start = outline.back().back;
  append_taper(outline, start + 0.06 * scene_size, slim, 6);
  append_taper(outline, start + 0.52 * scene_size, slim, 1);
  append_taper(outline, start + 0.62 * scene_size, thick, 8);
  for (const double back : {0.64, 0.66, 1.16, 1.18}) {
    const bool ringed = back > 0.65 && back < 1.17;
    outline.push_back({.back = start + back * scene_size, .out = thick, .grip = ringed ? 1.0f : 0.0f});
  }
  append_arc(outline, start + 3.0 * scene_size, thick, 0.5 * std::numbers::pi, std::numbers::pi, kBrushed, 8);
}

/// One millimetre where the scene allows: a probe neither vanishes in a large scene nor fills a small one.
double probe_radius(double scene_size) {
  return std::clamp(0.001, 0.006 * scene_size, 0.012 * scene_size);
}

ToolShape probe(const SnapshotTool& tool, double scene_size) {
  const double radius = probe_radius(scene_size);
  ToolBuilder builder(tool, scene_size);
  std::vector<OutlinePoint> outline;
  append_arc(outline, radius, radius, 0, 0.5 * std::numbers::pi, kPolished, 10);
  append_shaft(outline, 1.25 * radius, 3 * radius, scene_size);
  builder.turn(outline);
  builder.add_rod(radius, outline.back().back, radius);
  return builder.take();
}

ToolShape straight_edge(const SnapshotTool& tool, double scene_size) {
  const double radius = 0.6 * probe_radius(scene_size);
  const double height = 0.09 * scene_size;
  ToolBuilder builder(tool, scene_size);
  std::vector<OutlinePoint> outline;
  append_arc(outline, radius, radius, -0.5 * std::numbers::pi, 0.5 * std::numbers::pi, kBrushed, 12);
  append_arc(outline, height - radius, radius, 0.5 * std::numbers::pi, 1.5 * std::numbers::pi, kBrushed, 12);
  outline.push_back(outline.front());
  builder.draw_out(outline, tool.length);
  std::vector<OutlinePoint> shaft;
  append_arc(shaft, height, 3 * radius, 0, 0.5 * std::numbers::pi, kBrushed, 8);
  append_shaft(shaft, 3 * radius, 5 * radius, scene_size);
  builder.turn(shaft);
  builder.add_rod_along_axis(radius, tool.length, radius);
  builder.add_rod(height, shaft.back().back, 3 * radius);
  return builder.take();
}

ToolShape ball(const SnapshotTool& tool, double scene_size) {
  const double radius = std::max(tool.radius, 0.0);
  const double slim = std::min(0.3 * radius, 0.02 * scene_size);
  const double joint = radius > 0 ? std::numbers::pi - std::asin(1.4 * slim / radius) : 0;
  ToolBuilder builder(tool, scene_size);
  std::vector<OutlinePoint> outline;
  append_arc(outline, radius, radius, 0, joint, kPolished, 18);
  append_fillet(outline, slim);
  append_shaft(outline, slim, std::min(1.5 * slim, 0.03 * scene_size), scene_size);
  builder.turn(outline);
  builder.add_rod(radius, radius, radius);
  builder.add_rod(2 * radius, outline.back().back, slim);
  return builder.take();
}

/// From the outline's last point, of a handle's front: a collar between two grooves, then rings for the fingers.
void append_grip(std::vector<OutlinePoint>& outline, double out, double scene_size) {
  const double start = outline.back().back;
  const double depth = 0.12 * out, groove = 0.35 * out;
  for (const double back : {0.8, 2.2}) {
    const double front = start + back * out;
    outline.push_back({.back = front, .out = out});
    append_taper(outline, front + 0.5 * groove, out - depth, 4);
    append_taper(outline, front + groove, out, 4);
  }
  const double rings = outline.back().back + 0.6 * out;
  const double step = 1.0 / kToolRings;
  // Whole rings, so that they begin and end smoothly.
  const double first = std::ceil(rings / scene_size / step) * step, last = first + 24 * step;
  for (const double back : {first, first + 0.5 * step, last - 0.5 * step, last}) {
    const bool ringed = back > first && back < last;
    outline.push_back({.back = back * scene_size, .out = out, .grip = ringed ? 1.0f : 0.0f});
  }
}

/// A round shaft with a handle that begins `back` behind the tip, thick enough to be seen and no thicker than `widest`.
void add_handle(ToolBuilder& builder, double back, double widest, double scene_size) {
  const double radius = std::min(2.5 * probe_radius(scene_size), widest);
  const double front = back - std::sqrt(0.5) * radius;
  std::vector<OutlinePoint> outline;
  for (const double out : {0.0, std::sqrt(0.5) * radius}) {
    outline.push_back({.back = front, .out = out, .normal_back = -1, .normal_out = 0});
  }
  append_arc(outline, back, radius, 0.25 * std::numbers::pi, 0.5 * std::numbers::pi, kBrushed, 6);
  append_grip(outline, radius, scene_size);
  append_shaft(outline, radius, 1.7 * radius, scene_size);
  builder.turn(outline);
  builder.add_rod(back, outline.back().back, radius);
}

/// A rectangle from the tip backwards, `middle` aside of it along x', its corners rounded by `rounding`.
std::vector<OutlinePoint> rectangle(double middle, double width, double length, double rounding) {
  std::vector<OutlinePoint> outline;
  for (int corner = 0; corner < 4; ++corner) {
    const bool front = corner < 2, right = corner == 1 || corner == 2;
    std::vector<OutlinePoint> arc;
    append_arc(arc, front ? rounding : length - rounding, rounding, 0.5 * (corner - 1) * std::numbers::pi,
               0.5 * corner * std::numbers::pi, kBrushed, 5);
    const double aside = middle + (right ? 0.5 : -0.5) * (width - 2 * rounding);
    for (OutlinePoint& point : arc) point.out += aside;
    outline.insert(outline.end(), arc.begin(), arc.end());
  }
  outline.push_back(outline.front());
  return outline;
}

ToolShape rod(const SnapshotTool& tool, double scene_size) {
  const double radius = tool.radius, length = std::max(tool.length, 2 * radius);
  ToolBuilder builder(tool, scene_size);
  // The rod itself is turned about y': a tool of its own that lies across.
  const Vector3 direction = normalized(vector3(tool.direction), {0, 0, -1});
  const Vector3 axis = normalized(vector3(tool.axis), perpendicular(direction));
  const Vector3 end = vector3(tool.tip) - radius * direction + 0.5 * length * axis;
  SnapshotTool across = tool;
  across.tip = {end.x, end.y, end.z};
  across.direction = {axis.x, axis.y, axis.z};
  across.axis = tool.direction;
  ToolBuilder lying(across, scene_size);
  std::vector<OutlinePoint> outline;
  append_arc(outline, radius, radius, 0, 0.5 * std::numbers::pi, kPolished, 12);
  append_arc(outline, length - radius, radius, 0.5 * std::numbers::pi, std::numbers::pi, kPolished, 12);
  lying.turn(outline);
  lying.add_rod(radius, length - radius, radius);
  builder.add(lying.take());
  add_handle(builder, radius, 0.5 * radius, scene_size);
  return builder.take();
}

ToolShape plate(const SnapshotTool& tool, double scene_size) {
  ToolBuilder builder(tool, scene_size);
  const double rounding = std::min({1e-4, 0.25 * tool.thickness, 0.25 * tool.width, 0.25 * tool.length});
  builder.draw_out(rectangle(0, tool.width, tool.thickness, rounding), tool.length);
  builder.add_rod_along_axis(tool.thickness, tool.length, 0.5 * tool.thickness);
  add_handle(builder, tool.thickness, 0.25 * std::min(tool.width, tool.length), scene_size);
  return builder.take();
}

ToolShape needle(const SnapshotTool& tool, double scene_size) {
  // As the engine shapes it: a tip of 0.4 radii, a cone of four, a shaft.
  const double radius = tool.radius, tip = 0.4 * radius, shoulder = tip + 4 * radius;
  const double lean = std::asin((radius - tip) / (shoulder - tip));
  ToolBuilder builder(tool, scene_size);
  std::vector<OutlinePoint> outline;
  append_arc(outline, tip, tip, 0, 0.5 * std::numbers::pi - lean, kPolished, 10);
  append_arc(outline, shoulder, radius, 0.5 * std::numbers::pi - lean, 0.5 * std::numbers::pi, kPolished, 6);
  append_taper(outline, std::max(tool.length, shoulder + radius), radius, 1);
  append_shaft(outline, std::max(1.5 * radius, 2 * probe_radius(scene_size)),
               std::max(2 * radius, 3 * probe_radius(scene_size)), scene_size);
  builder.turn(outline);
  builder.add_rod(tip, outline.back().back, radius);
  return builder.take();
}

/// One jaw of forceps and the arm that it sits on: thinner towards its end, with teeth across its inner face. Nothing
/// of it stands out of what presses, a box with rounded edges. `side`: -1 or 1, along x'. `joint`: metres from the tip
/// to where the arms meet.
std::vector<FlatSection> jaw(const SnapshotTool& tool, double side, double joint) {
  constexpr double kToothed = 0.4;    // part of its length that has teeth
  constexpr double kRounding = 0.25;  // of the smallest of its sizes, of the edges
  constexpr int kArmSteps = 10, kTipSteps = 4;
  const double thick = tool.thickness, length = tool.length, inner = 0.5 * tool.opening;
  const double rounding = kRounding * std::min({thick, tool.width, length});
  const double tooth = std::clamp(0.5 * thick, length / 60, length / 12), depth = std::min(0.35 * tooth, 0.1 * thick);
  std::vector<FlatSection> sections;
  const auto add = [&](double back, double low, double high, double inset = 0) {
    const double half = 0.5 * (high - low);
    sections.push_back({.back = back,
                        .middle = side * (inner + 0.5 * (low + high)),
                        .half_thickness = half,
                        .half_width = 0.5 * tool.width - inset,
                        .chamfer = std::min(rounding - inset, 0.9 * half)});
  };
  const auto outside = [&](double back) { return thick * std::min(1.0, 0.55 + 0.45 * back / (0.35 * length)); };
  for (int k = kTipSteps - 1; k > 0; --k) {
    const double turned = 0.5 * std::numbers::pi * k / kTipSteps;
    const double back = (1 - std::sin(turned)) * rounding, inset = (1 - std::cos(turned)) * rounding;
    add(back, inset, outside(back) - 0.5 * inset, inset);
  }
  const int teeth = static_cast<int>(kToothed * length / tooth);
  for (int k = 0; k < teeth; ++k) {
    const double back = rounding + k * tooth;
    add(back, 0, outside(back));
    add(back + 0.85 * tooth, depth, outside(back + 0.85 * tooth));
  }
  add(rounding + teeth * tooth, 0, outside(rounding + teeth * tooth));
  add(length, 0, thick);
  for (int k = 1; k <= kArmSteps; ++k) {
    const double t = static_cast<double>(k) / kArmSteps, bent = t * t * (3 - 2 * t);
    sections.push_back({.back = length + t * (joint - length),
                        .middle = (1 - bent) * side * (inner + 0.5 * thick) + bent * side * 0.4 * thick,
                        .half_thickness = 0.5 * thick * (1 - 0.2 * bent),
                        .half_width = 0.5 * tool.width * (1 - 0.35 * bent),
                        .chamfer = rounding * (1 - 0.35 * bent)});
  }
  return sections;
}

ToolShape jaws(const SnapshotTool& tool, double scene_size) {
  ToolBuilder builder(tool, scene_size);
  // Where they meet does not move as they close.
  const double joint = 2 * tool.length;
  for (const double side : {-1.0, 1.0}) builder.join(jaw(tool, side, joint));
  add_handle(builder, joint, 0.35 * tool.width, scene_size);
  return builder.take();
}

}  // namespace

ToolShape tool_shape(const SnapshotTool& tool, double scene_size, ToolDetail detail) {
  switch (tool.kind) {
    case SnapshotToolKind::kPoint:
      return probe(tool, scene_size);
    case SnapshotToolKind::kLine:
      return straight_edge(tool, scene_size);
    case SnapshotToolKind::kSphere:
      return ball(tool, scene_size);
    case SnapshotToolKind::kCapsule:
      return rod(tool, scene_size);
    case SnapshotToolKind::kPlate:
      return plate(tool, scene_size);
    case SnapshotToolKind::kNeedle:
      return needle(tool, scene_size);
    case SnapshotToolKind::kScalpel:
      return scalpel_shape(tool, scene_size, detail);
    case SnapshotToolKind::kForceps:
      return jaws(tool, scene_size);
  }
  return {};
}

}  // namespace thinwall
