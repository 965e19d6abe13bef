#include "renderer/picture/ScalpelShape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "renderer/picture/ToolBuilder.hpp"
#include "renderer/picture/Vector.hpp"

namespace thinwall {
namespace {

// All in metres; places are (x', y', back from the tip), as in ToolBuilder::add_quad.

constexpr float kBlade = 0.14f;   // roughness of its faces
constexpr float kGround = 0.14f;  // and of its bevels

double smooth_step(double t) {
  return t * t * (3 - 2 * t);
}

/// The blade in front of its mount; all lengths but `length` grow with its width.
struct Blade {
  explicit Blade(const SnapshotTool& tool)
      : wide(0.5 * tool.width),
        thick(0.5 * tool.thickness),
        length(tool.length),
        bevel(std::min(0.4 * wide, 0.1 * length)),
        point(-0.35 * wide),
        slant(std::min(1.7 * wide, 0.45 * length)),
        belly(std::min(2.2 * wide, 0.6 * length)) {}

  double wide;   // half of the width
  double thick;  // half of the thickness
  double length;
  double bevel;  // width of what is ground off
  double point;  // y' of the point, where the edge meets the back
  double slant;  // how far up the back has its whole distance
  double belly;  // and the edge

  double back_side(double back) const { return std::lerp(point, -wide, std::min(back / slant, 1.0)); }
};

/// A place of the edge, and where its bevel ends.
struct EdgePlace {
  Vector3 edge{};
  Vector3 inner{};
  Vector3 inward{};  // from one to the other
};

/// From the point along the edge to the mount.
std::vector<EdgePlace> edge_places(const Blade& blade) {
  constexpr int kSteps = 14;
  const auto place = [&](double y, double back, Vector3 inward) {
    const Vector3 edge{0, y, back};
    return EdgePlace{edge, edge + blade.bevel * inward, inward};
  };
  std::vector<EdgePlace> places = {place(blade.point, 0, {0, 0, 1})};
  places.front().inner.y = blade.back_side(blade.bevel);
  for (int k = 0; k <= kSteps; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / kSteps;
    const double y = blade.wide * std::sin(angle), back = blade.belly * (1 - std::cos(angle));
    // Across the ellipse.
    const Vector3 inward = normalized({0, -blade.belly * std::sin(angle), blade.wide * std::cos(angle)});
    places.push_back(place(y, back, inward));
  }
  places.push_back(place(blade.wide, blade.length, {0, -1, 0}));
  return places;
}

void add_flat(ToolBuilder& builder, const std::array<Vector3, 4>& corners, Vector3 outward, float roughness) {
  const Vector3 across = normalized(cross(corners[2] - corners[0], corners[3] - corners[1]), outward);
  const Vector3 normal = dot(across, outward) < 0 ? -across : across;
  builder.add_quad(corners, {normal, normal, normal, normal}, roughness);
}

void add_blade(ToolBuilder& builder, const Blade& blade, BladeEdge edge) {
  const std::vector<EdgePlace> places = edge_places(blade);
  const double edge_thick = edge == BladeEdge::kSharp ? 0 : 0.04 * blade.thick;
  const auto at = [](Vector3 place, double x) { return Vector3{x, place.y, place.z}; };
  const auto on_back = [&](double x, double back) { return Vector3{x, blade.back_side(back), back}; };
  // Hollow, so that its faces mirror more than one place.
  const auto hollow = [&](double sense, Vector3 place) {
    return normalized(Vector3{sense, -0.16 * place.y / blade.wide, 0});
  };
  for (std::size_t k = 1; k < places.size(); ++k) {
    const EdgePlace &low = places[k - 1], &high = places[k];
    for (const double sense : {-1.0, 1.0}) {
      const double thick = sense * blade.thick, sharp = sense * edge_thick;
      const auto ground = [&](const EdgePlace& place) {
        return Vector3{sense * blade.bevel, 0, 0} - (blade.thick - edge_thick) * place.inward;
      };
      builder.add_quad({at(low.edge, sharp), at(high.edge, sharp), at(high.inner, thick), at(low.inner, thick)},
                       {ground(low), ground(high), ground(high), ground(low)}, kGround);
      if (k == 1) continue;  // from there on up to the back
      const Vector3 low_inner = at(low.inner, thick), high_inner = at(high.inner, thick);
      const Vector3 low_back = on_back(thick, low.inner.z), high_back = on_back(thick, high.inner.z);
      builder.add_quad(
          {low_inner, high_inner, high_back, low_back},
          {hollow(sense, low_inner), hollow(sense, high_inner), hollow(sense, high_back), hollow(sense, low_back)},
          kBlade);
    }
    if (edge == BladeEdge::kGround) {
      add_flat(
          builder,
          {at(low.edge, -edge_thick), at(low.edge, edge_thick), at(high.edge, edge_thick), at(high.edge, -edge_thick)},
          -low.inward - high.inward, kGround);
    }
    const double from = k == 1 ? 0 : low.inner.z, to = high.inner.z;
    const double from_thick = k == 1 ? edge_thick : blade.thick;
    add_flat(
        builder,
        {on_back(-from_thick, from), on_back(from_thick, from), on_back(blade.thick, to), on_back(-blade.thick, to)},
        {0, -1, 0}, kBlade);
  }
  const EdgePlace& end = places.back();
  const Vector3 rear{0, 0, 1};
  add_flat(builder,
           {on_back(-blade.thick, blade.length), on_back(blade.thick, blade.length), at(end.inner, blade.thick),
            at(end.inner, -blade.thick)},
           rear, kBlade);
  add_flat(
      builder,
      {at(end.inner, -blade.thick), at(end.inner, blade.thick), at(end.edge, edge_thick), at(end.edge, -edge_thick)},
      rear, kBlade);
}

/// A line across a plate with a slot along its middle.
struct PlateRow {
  double back = 0;  // where it crosses the middle
  double lean = 0;  // how much farther back it is for each metre towards -y'
  double wide = 0;  // half of the plate's width
  double slot = 0;  // half of the slot's width
};

void add_plate(ToolBuilder& builder, const std::vector<PlateRow>& rows, double thick) {
  const auto at = [](const PlateRow& row, double x, double y) { return Vector3{x, y, row.back - row.lean * y}; };
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const PlateRow &low = rows[k - 1], &high = rows[k];
    for (const double side : {-1.0, 1.0}) {
      for (const double x : {-thick, thick}) {
        add_flat(builder,
                 {at(low, x, side * low.slot), at(low, x, side * low.wide), at(high, x, side * high.wide),
                  at(high, x, side * high.slot)},
                 {x, 0, 0}, kBlade);
      }
      const auto wall = [&](double from, double to, double outward) {
        add_flat(builder,
                 {at(low, -thick, side * from), at(low, thick, side * from), at(high, thick, side * to),
                  at(high, -thick, side * to)},
                 {0, side * outward, 0}, kBlade);
      };
      wall(low.wide, high.wide, 1);
      if (low.slot > 0 || high.slot > 0) wall(low.slot, high.slot, -1);
    }
  }
  for (const PlateRow* row : {&rows.front(), &rows.back()}) {
    add_flat(builder,
             {at(*row, -thick, -row->wide), at(*row, thick, -row->wide), at(*row, thick, row->wide),
              at(*row, -thick, row->wide)},
             {0, 0, row == &rows.front() ? -1.0 : 1.0}, kBlade);
  }
}

/// Where the blade sits on the tang: it widens, has a slot, and ends aslant.
void add_mount(ToolBuilder& builder, const Blade& blade) {
  constexpr int kShoulder = 5, kRound = 4;
  const double wide = blade.wide, mount = 1.22 * wide, slot = 0.36 * wide;
  std::vector<PlateRow> rows;
  for (int k = 0; k <= kShoulder; ++k) {
    const double t = static_cast<double>(k) / kShoulder;
    rows.push_back({.back = blade.length + 0.8 * wide * t, .wide = std::lerp(wide, mount, smooth_step(t))});
  }
  const double front = blade.length + 1.1 * wide, rear = blade.length + 3.9 * wide;
  for (int k = 0; k <= kRound; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / kRound;
    rows.push_back({.back = front + 2 * slot * (1 - std::cos(angle)), .wide = mount, .slot = slot * std::sin(angle)});
  }
  for (int k = kRound; k >= 0; --k) {
    const double angle = 0.5 * std::numbers::pi * k / kRound;
    rows.push_back({.back = rear - slot * (1 - std::cos(angle)), .wide = mount, .slot = slot * std::sin(angle)});
  }
  rows.push_back({.back = rear + 0.9 * wide, .lean = 0.45, .wide = mount});
  add_plate(builder, rows, blade.thick);
}

/// The tang, a neck, a flat handle with grooves for the fingers, and its round end.
void add_handle(ToolBuilder& builder, const Blade& blade, double scene_size) {
  constexpr int kWidening = 8, kRound = 6;
  const double wide = blade.wide, neck = blade.length + 4.3 * wide;
  // Wide enough to be seen in a large scene, and not to fill a small one.
  const double handle = std::clamp(0.045 * scene_size, 1.4 * wide, 2.0 * wide);
  const double thick = std::max(0.28 * handle, 1.5 * blade.thick), tang = std::min(2.2 * blade.thick, thick);
  builder.join({{.back = blade.length + 2.1 * wide, .half_thickness = 0.7 * tang, .half_width = 0.12 * wide},
                {.back = blade.length + 2.5 * wide, .half_thickness = tang, .half_width = 0.31 * wide},
                {.back = neck + 0.2 * wide, .half_thickness = tang, .half_width = 0.31 * wide}});

  std::vector<FlatSection> sections = {
      {.back = neck, .half_thickness = 1.2 * blade.thick, .half_width = 1.05 * wide},
      {.back = neck + 0.5 * wide, .half_thickness = 0.8 * thick, .half_width = 1.15 * wide},
  };
  const auto add = [&](double back, double half_width, float grip = 0) {
    sections.push_back({.back = back, .half_thickness = thick, .half_width = half_width, .grip = grip});
  };
  const double start = neck + 1.1 * wide, full = start + 2.2 * handle;
  for (int k = 0; k <= kWidening; ++k) {
    const double t = static_cast<double>(k) / kWidening;
    add(std::lerp(start, full, t), std::lerp(1.15 * wide, handle, smooth_step(t)), t > 0.4 ? 1.0F : 0.0F);
  }
  const double end = full + std::max(1.1 * scene_size, 12 * handle);
  add(full + 6 * handle, 0.94 * handle, 1);
  for (int k = 0; k < kRound; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / kRound;
    add(end - handle * (1 - std::sin(angle)), handle * std::cos(angle));
  }
  builder.join(sections);
  builder.add_rod(neck, end, 0.5 * handle);
}

}  // namespace

ToolShape scalpel_shape(const SnapshotTool& tool, double scene_size, BladeEdge edge) {
  const Blade blade(tool);
  ToolBuilder builder(tool, scene_size);
  add_blade(builder, blade, edge);
  add_mount(builder, blade);
  builder.add_rod_along_axis(0.5 * tool.thickness, tool.width, 0.5 * tool.thickness);
  add_handle(builder, blade, scene_size);
  return builder.take();
}

}  // namespace thinwall
