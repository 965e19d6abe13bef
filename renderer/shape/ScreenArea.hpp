#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "renderer/image/Image.hpp"
#include "renderer/shape/SurfaceVertices.hpp"
#include "renderer/shape/ToolShape.hpp"

namespace thinwall {

/// Pixels of a picture, counted from its lower left corner.
struct ScreenArea {
  int left = 0;
  int bottom = 0;
  int width = 0;
  int height = 0;
  bool operator==(const ScreenArea&) const = default;
};

/// A box along the axes, metres.
struct Bounds {
  Float3 least{};
  Float3 most{};
};

/// The smallest box around `vertices`, of which there is at least one.
Bounds bounds_of(std::span<const SurfaceVertex> vertices);

/// The smallest box around both.
Bounds around(const Bounds& a, const Bounds& b);

/// x, y, z, w; what lies behind the eye has w below zero.
using ClipPlace = std::array<double, 4>;

/// `matrix`: world to clip coordinates, column by column.
ClipPlace clip_place(const Float3& place, const std::array<float, 16>& matrix);

/// Of a corner of `box`; bit k of `which` chooses the end on axis k.
ClipPlace clip_corner(const Bounds& box, unsigned which, const std::array<float, 16>& matrix);

/// Nearer to the eye's plane, in w, nothing has a place on the screen.
constexpr double kNearestPlace = 1e-6;

/// The smallest around places on the screen, -1 to 1 on both axes.
struct ScreenFrame {
  static constexpr double kFar = std::numeric_limits<double>::max();
  std::array<double, 2> least{kFar, kFar}, most{-kFar, -kFar};

  /// `place` has one on the screen.
  void add(const ClipPlace& place);
  bool meets(const ScreenFrame& other) const;
};

/// Whether all of `box` lies beyond the near plane of a view, so that it is seen from outside.
bool lies_ahead(const Bounds& box, const std::array<float, 16>& view_projection);

/// Depth along the line of sight, metres, below which nothing of the box lies; at least 0.
float nearest_depth(const Bounds& box, const std::array<float, 16>& view_projection);

/// All pixels that show something of `box`, and a border of one; everything where the box reaches behind the eye.
/// `view_projection`: world to clip coordinates, column by column.
ScreenArea screen_area(const Bounds& box, const std::array<float, 16>& view_projection, ImageSize size);

/// The smallest around both; an empty one has no place.
ScreenArea around(const ScreenArea& a, const ScreenArea& b);

/// The same of triangles, and only of what of them lies before the eye: of a tool that is held from behind it, as much
/// as is seen. `corners`: (3 x triangles), into `vertices`.
ScreenArea screen_area(std::span<const ToolVertex> vertices, std::span<const std::uint32_t> corners,
                       const std::array<float, 16>& view_projection, ImageSize size);

}  // namespace thinwall
