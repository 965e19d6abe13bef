#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/shape/Outline.hpp"
#include "renderer/shape/ToolShape.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// Finds what divides tools from what is seen behind them, and their creases. Faces have vertices of their own where
/// the shading has a crease; here those at one place, to the last bit, are one.
class ToolOutline {
 public:
  /// The tools as they are now; `corners` (3 x triangles), counter-clockwise from outside. Which triangles are
  /// neighbours is found again only where it has changed.
  void set(std::span<const ToolVertex> vertices, std::span<const std::uint32_t> corners);

  /// The edges between a triangle that faces `eye` and one that does not, and the creases between two that do. Of what
  /// lies on the far side there is nothing, which would smooth what hides it. Nor are there creases beside narrow sides
  /// that are about a pixel wide and less: what is beyond them would come from beyond their other border. `pixel`:
  /// height of one over the distance.
  void append(std::span<const ToolVertex> vertices, Vector3 eye, double pixel,
              std::vector<OutlineSegment>& outline) const;

 private:
  /// One side of an edge: vertices of a triangle, in its order.
  struct Side {
    std::uint32_t start = 0;
    std::uint32_t end = 0;
    std::uint32_t third = 0;
  };
  struct Edge {
    Side near;
    Side other;
    bool is_border = false;  // without the other
  };

  std::vector<std::uint32_t> places_;  // (3 x triangles), the first vertex at the place of each corner
  std::vector<Edge> edges_;
};

}  // namespace thinwall
