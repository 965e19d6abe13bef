#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace thinwall {

/// 128 bits: what a determinant of three 41-bit differences needs.
__extension__ typedef __int128 WideInteger;

/// A point of the grid, in its units.
using GridPoint = std::array<std::int64_t, 3>;

/// A grid so fine that rounding to it is round-off, and so coarse that volumes between its points are exact: 2^39 to
/// 2^40 units along the largest extent, so that a point moves by at most 2e-12 of it.
class ExactGrid {
 public:
  /// Holds all points of the box from `low` to `high`, metres.
  ExactGrid(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

  GridPoint at(const Eigen::Vector3d& point) const;
  double unit() const { return unit_; }  // metres, a power of two

 private:
  Eigen::Vector3d middle_;
  double unit_ = 1;
};

/// Six times the volume of the tetrahedron a, b, c, d: (b - a) x (c - a) . (d - a), exactly. No sum in between
/// overflows for points of one grid: each product has at most 123 bits.
WideInteger volume(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d);

/// (b - a) x (d - c), exactly; 83 bits.
std::array<WideInteger, 3> cross(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d);

/// -1, 0 or 1, of a vector the sign of its first part that is not zero: that of its product with (1, e, e^2) for small
/// e.
int sign_of(WideInteger value);
int sign_of(const std::array<WideInteger, 3>& vector);

}  // namespace thinwall
