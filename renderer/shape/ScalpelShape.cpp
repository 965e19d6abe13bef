#include "renderer/shape/ScalpelShape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "renderer/shape/ToolBuilder.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {
namespace {

// All in metres; places are (x', y', back from the tip), as in ToolBuilder::add_quad.

constexpr float kBlade = 0.07f;    // roughness of its faces
constexpr float kGround = 0.09f;   // and of its bevels
constexpr float kStamped = 0.22f;  // and of its narrow sides
constexpr double kHollow = 0.24;   // by how much broad faces of the blade lean at their borders: they are hollow ground
constexpr double kMountHollow = 0.16;  // and of its mount

/// By how much more than its middle a narrow side leans at its edges: it is rounded by use, so that a line of it always
/// glints. Within a slot it is seen so much along itself that light and dark would alternate from pixel to pixel.
constexpr double kRounding = 0.3;

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
        belly(std::min(3.4 * wide, 0.65 * length)) {}

  double wide;   // half of the width
  double thick;  // half of the thickness
  double length;
  double bevel;  // width of what is ground off
  double belly;  // how far behind the point edge and back have their whole distance from the middle

  /// The back comes down to the point in a curve, as where a straight one ended in a slant the corner would be seen.
  double back_side(double back) const {
    const double t = std::min(back / belly, 1.0);
    return -0.5 * wide * t * (3 - t * t);
  }
  Vector3 back_outward(double back) const {
    const double t = std::min(back / belly, 1.0);
    return {0, -1, -1.5 * wide / belly * (1 - t * t)};
  }
};

/// A place of the edge, and where its bevel ends.
struct EdgePlace {
  Vector3 edge{};
  Vector3 inner{};
  Vector3 inward{};   // from one to the other
  double ground = 1;  // part of the bevel's width that there is room for before the back
};

/// At the point edge and back meet, and the bevel has no width.
EdgePlace edge_place(const Blade& blade, double y, double back, Vector3 inward) {
  const Vector3 edge{0, y, back};
  const auto is_blade = [&](double part) {
    const Vector3 place = edge + part * blade.bevel * inward;
    return place.y >= blade.back_side(place.z);
  };
  double ground = 0, beyond = 1;
  if (is_blade(beyond)) ground = 1;
  for (int halving = 0; halving < 20 && ground < 1; ++halving) {
    const double middle = 0.5 * (ground + beyond);
    (is_blade(middle) ? ground : beyond) = middle;
  }
  return {edge, edge + ground * blade.bevel * inward, inward, ground};
}

/// From the point along the edge to the mount: an arc of an ellipse that is cut off aslant by the back.
std::vector<EdgePlace> edge_places(const Blade& blade) {
  constexpr int kSteps = 24;
  constexpr double kFirst = std::numbers::pi / 6;  // angle on the ellipse at which it begins
  std::vector<EdgePlace> places;
  for (int k = 0; k <= kSteps; ++k) {
    const double angle = std::lerp(kFirst, 0.5 * std::numbers::pi, static_cast<double>(k) / kSteps);
    const double across = blade.wide / (1 - std::sin(kFirst)), along = blade.belly / std::cos(kFirst);
    const double y = across * (std::sin(angle) - std::sin(kFirst));
    const double back = along * (std::cos(kFirst) - std::cos(angle));
    const Vector3 inward = normalized({0, -along * std::sin(angle), across * std::cos(angle)});
    places.push_back(edge_place(blade, y, back, inward));
  }
  places.push_back(edge_place(blade, blade.wide, blade.length, {0, -1, 0}));
  return places;
}

void add_flat(ToolBuilder& builder, const std::array<Vector3, 4>& corners, Vector3 outward, float roughness) {
  const Vector3 across = normalized(cross(corners[2] - corners[0], corners[3] - corners[1]), outward);
  const Vector3 normal = dot(across, outward) < 0 ? -across : across;
  builder.add_quad(corners, {normal, normal, normal, normal}, roughness);
}

/// A narrow side between two broad ones, its corners at -x', x', x', -x'. It turns from one outward normal to the
/// other, and leans by `rounding` at its edges, where the broad ones lean by `hollow`; where that is not told it is
/// seen however narrow it is.
void add_narrow(ToolBuilder& builder, const std::array<Vector3, 4>& corners, Vector3 front, Vector3 rear,
                double rounding, std::optional<double> hollow) {
  const Vector3 aside{rounding, 0, 0};
  const Vector3 from = normalized(front), to = normalized(rear);
  const std::array<Vector3, 4> normals = {from - aside, from + aside, to + aside, to - aside};
  if (hollow) {
    builder.add_narrow_quad(corners, normals, kStamped, *hollow, kBlade);
  } else {
    builder.add_quad(corners, normals, kStamped);
  }
}

/// The bevel and the broad face behind it on the side of `sense` (-1 or 1 along x'), between two places of the edge.
void add_broad_side(ToolBuilder& builder, const Blade& blade, const EdgePlace& low, const EdgePlace& high,
                    double edge_thick, double sense) {
  const auto at = [](Vector3 place, double x) { return Vector3{x, place.y, place.z}; };
  const auto inner = [&](const EdgePlace& place) {
    return at(place.inner, sense * std::lerp(edge_thick, blade.thick, place.ground));
  };
  const auto on_back = [&](const EdgePlace& place) {
    const Vector3 there = inner(place);
    return Vector3{there.x, blade.back_side(there.z), there.z};
  };
  const auto hollow = [&](Vector3 place) { return normalized(Vector3{sense, -kHollow * place.y / blade.wide, 0}); };
  // The bevel is rounder towards the edge.
  const auto ground = [&](const EdgePlace& place, double lean) {
    return Vector3{sense * blade.bevel, 0, 0} - lean * (blade.thick - edge_thick) * place.inward;
  };
  builder.add_quad({at(low.edge, sense * edge_thick), at(high.edge, sense * edge_thick), inner(high), inner(low)},
                   {ground(low, 1.5), ground(high, 1.5), ground(high, 0.7), ground(low, 0.7)}, kGround);
  const std::array<Vector3, 4> face = {inner(low), inner(high), on_back(high), on_back(low)};
  builder.add_quad(face, {hollow(face[0]), hollow(face[1]), hollow(face[2]), hollow(face[3])}, kBlade);
}

void add_blade(ToolBuilder& builder, const Blade& blade, ToolDetail detail) {
  const std::vector<EdgePlace> places = edge_places(blade);
  const double edge_thick = detail == ToolDetail::kSeen ? 0 : 0.04 * blade.thick;
  const auto at = [](Vector3 place, double x) { return Vector3{x, place.y, place.z}; };
  const auto on_back = [&](double x, double back) { return Vector3{x, blade.back_side(back), back}; };
  for (std::size_t k = 1; k < places.size(); ++k) {
    const EdgePlace &low = places[k - 1], &high = places[k];
    for (const double sense : {-1.0, 1.0}) add_broad_side(builder, blade, low, high, edge_thick, sense);
    if (detail == ToolDetail::kAll) {
      add_flat(
          builder,
          {at(low.edge, -edge_thick), at(low.edge, edge_thick), at(high.edge, edge_thick), at(high.edge, -edge_thick)},
          -low.inward - high.inward, kGround);
    }
    const double from = std::lerp(edge_thick, blade.thick, low.ground);
    const double to = std::lerp(edge_thick, blade.thick, high.ground);
    add_narrow(builder,
               {on_back(-from, low.inner.z), on_back(from, low.inner.z), on_back(to, high.inner.z),
                on_back(-to, high.inner.z)},
               blade.back_outward(low.inner.z), blade.back_outward(high.inner.z), kRounding, kHollow);
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
  double hollow = kMountHollow;
  float shade = 0;        // part of the light that the tang takes in the middle
  float outer_shade = 0;  // and the handle at the sides
};

/// The outward normal of a plate's narrow side on the side of y', at row `k`, between those of the faces beside it; not
/// of length one. `half`: PlateRow::wide, or slot, whose wall faces the other way.
Vector3 side_normal(const std::vector<PlateRow>& rows, std::size_t k, double PlateRow::*half) {
  Vector3 sum{};
  for (std::size_t high = std::max<std::size_t>(k, 1); high <= std::min(k + 1, rows.size() - 1); ++high) {
    const PlateRow &a = rows[high - 1], &b = rows[high];
    if (a.*half > 0 || b.*half > 0) sum = sum + normalized({0, b.back - a.back, a.*half - b.*half});
  }
  return sum;
}

void add_plate(ToolBuilder& builder, const std::vector<PlateRow>& rows, double thick, double slot_rounding) {
  const auto at = [](const PlateRow& row, double x, double y) { return Vector3{x, y, row.back - row.lean * y}; };
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const PlateRow &low = rows[k - 1], &high = rows[k];
    for (const double side : {-1.0, 1.0}) {
      for (const double x : {-thick, thick}) {
        const std::array<Vector3, 4> face = {at(low, x, side * low.slot), at(low, x, side * low.wide),
                                             at(high, x, side * high.wide), at(high, x, side * high.slot)};
        const auto normal = [&](const PlateRow& row, double half) {
          return normalized(Vector3{x > 0 ? 1.0 : -1.0, -row.hollow * side * half / row.wide, 0});
        };
        builder.add_quad(
            face, {normal(low, low.slot), normal(low, low.wide), normal(high, high.wide), normal(high, high.slot)},
            kBlade, {low.shade, low.outer_shade, high.outer_shade, high.shade});
      }
      const auto wall = [&](double PlateRow::*half, double outward, double rounding, std::optional<double> hollow) {
        const auto normal = [&](std::size_t row) {
          const Vector3 own = side_normal(rows, row, half);
          return outward * Vector3{0, side * own.y, own.z};
        };
        add_narrow(builder,
                   {at(low, -thick, side * low.*half), at(low, thick, side * low.*half),
                    at(high, thick, side * high.*half), at(high, -thick, side * high.*half)},
                   normal(k - 1), normal(k), rounding, hollow);
      };
      wall(&PlateRow::wide, 1, kRounding, low.hollow);
      if (low.slot > 0 || high.slot > 0) wall(&PlateRow::slot, -1, slot_rounding, {});
    }
  }
  for (const PlateRow* row : {&rows.front(), &rows.back()}) {
    add_flat(builder,
             {at(*row, -thick, -row->wide), at(*row, thick, -row->wide), at(*row, thick, row->wide),
              at(*row, -thick, row->wide)},
             {0, 0, row == &rows.front() ? -1.0 : 1.0}, kBlade);
  }
}

constexpr double kSlot = 0.36;  // width of a slot, over the blade's

/// Where the blade sits on the tang: it widens, has a slot, and ends aslant.
void add_mount(ToolBuilder& builder, const Blade& blade, ToolDetail detail) {
  constexpr int kShoulder = 10, kRound = 8;
  const double wide = blade.wide, mount = 1.22 * wide, slot = kSlot * wide;
  std::vector<PlateRow> rows;
  for (int k = 0; k <= kShoulder; ++k) {
    const double t = static_cast<double>(k) / kShoulder;
    rows.push_back({.back = blade.length + 0.8 * wide * t,
                    .wide = std::lerp(wide, mount, smooth_step(t)),
                    .hollow = std::lerp(kHollow, kMountHollow, smooth_step(t))});
  }
  const double front = blade.length + 1.1 * wide, rear = blade.length + 3.9 * wide;
  for (int k = 0; k <= kRound; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / kRound;
    rows.push_back({.back = front + 2 * slot * (1 - std::cos(angle)), .wide = mount, .slot = slot * std::sin(angle)});
  }
  // Where the tang lies in the slot it shades the borders of that, as the handle's front does all below it.
  constexpr float kTangShade = 0.55F, kHandleShade = 0.5F;
  rows.push_back({.back = blade.length + 2.0 * wide, .wide = mount, .slot = slot});
  rows.push_back({.back = blade.length + 2.5 * wide, .wide = mount, .slot = slot, .shade = kTangShade});
  for (int k = kRound; k >= 0; --k) {
    const double angle = 0.5 * std::numbers::pi * k / kRound;
    rows.push_back({.back = rear - slot * (1 - std::cos(angle)),
                    .wide = mount,
                    .slot = slot * std::sin(angle),
                    .shade = kTangShade,
                    .outer_shade = 0.6F * kHandleShade * static_cast<float>(std::cos(angle))});
  }
  rows.push_back(
      {.back = rear + 0.9 * wide, .lean = 0.45, .wide = mount, .shade = kTangShade, .outer_shade = kHandleShade});
  add_plate(builder, rows, blade.thick, detail == ToolDetail::kSeen ? 0 : kRounding);
}

/// The tang, a neck, a flat handle with grooves for the fingers, and its round end.
void add_handle(ToolBuilder& builder, const Blade& blade, double scene_size, ToolDetail detail) {
  constexpr int kWidening = 8, kRound = 6;
  const double wide = blade.wide, neck = blade.length + 4.3 * wide;
  // Wide enough to be seen in a large scene, and not to fill a small one.
  const double handle = std::clamp(0.045 * scene_size, 1.4 * wide, 2.0 * wide);
  const double thick = std::max(0.28 * handle, 1.5 * blade.thick);
  // As it is seen its sides go into the borders of the slot, and come out of the blade with an edge.
  const bool is_seen = detail == ToolDetail::kSeen;
  const double tang = std::min((is_seen ? 2.004 : 2.2) * blade.thick, thick);
  const double tang_wide = (is_seen ? kSlot + 0.01 : 0.31) * wide;
  builder.join({{.back = blade.length + 2.1 * wide, .half_thickness = 0.7 * tang, .half_width = 0.12 * wide},
                {.back = blade.length + 2.5 * wide, .half_thickness = tang, .half_width = tang_wide},
                {.back = neck + 1.1 * wide, .half_thickness = tang, .half_width = tang_wide}});

  std::vector<FlatSection> sections = {
      // On the face of the blade its front is an edge: where faces go through each other stairs are seen.
      {.back = neck, .half_thickness = (is_seen ? 1.002 : 0.8) * blade.thick, .half_width = 1.05 * wide},
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
  const double end = full + std::max(2.6 * scene_size, 12 * handle);
  add(full + 6 * handle, 0.94 * handle, 1);
  for (int k = 0; k < kRound; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / kRound;
    add(end - handle * (1 - std::sin(angle)), handle * std::cos(angle));
  }
  builder.join(sections);
  builder.add_rod(neck, end, 0.5 * handle);
}

}  // namespace

ToolShape scalpel_shape(const SnapshotTool& tool, double scene_size, ToolDetail detail) {
  const Blade blade(tool);
  ToolBuilder builder(tool, scene_size);
  add_blade(builder, blade, detail);
  add_mount(builder, blade, detail);
  builder.add_rod(0, blade.length + 4.3 * blade.wide, 0.5 * blade.wide);
  add_handle(builder, blade, scene_size, detail);
  return builder.take();
}

}  // namespace thinwall
