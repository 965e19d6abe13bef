#include "engine/cutting/ExactGrid.hpp"

#include <cassert>
#include <cmath>

namespace thinwall {
namespace {

/// Grid points lie within this many units of the middle.
constexpr int kHalfBits = 39;

}  // namespace

ExactGrid::ExactGrid(const Eigen::Vector3d& low, const Eigen::Vector3d& high) : middle_(0.5 * (low + high)) {
  int exponent = 0;
  // frexp: half the extent < 2^exponent.
  std::frexp(0.5 * (high - low).maxCoeff(), &exponent);
  unit_ = std::ldexp(1.0, exponent - kHalfBits);
}

GridPoint ExactGrid::at(const Eigen::Vector3d& point) const {
  GridPoint result;
  for (int k = 0; k < 3; ++k) {
    const double units = (point[k] - middle_[k]) / unit_;
    assert(std::abs(units) <= std::ldexp(1.0, kHalfBits) + 1);
    result[k] = std::llround(units);
  }
  return result;
}

WideInteger volume(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  const std::array<WideInteger, 3> normal = cross(a, b, a, c);
  WideInteger sum = 0;
  for (int k = 0; k < 3; ++k) sum += normal[k] * (d[k] - a[k]);
  return sum;
}

std::array<WideInteger, 3> cross(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  std::array<WideInteger, 3> one, other;
  for (int k = 0; k < 3; ++k) {
    one[k] = b[k] - a[k];
    other[k] = d[k] - c[k];
  }
  return {one[1] * other[2] - one[2] * other[1], one[2] * other[0] - one[0] * other[2],
          one[0] * other[1] - one[1] * other[0]};
}

int sign_of(WideInteger value) {
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

int sign_of(const std::array<WideInteger, 3>& vector) {
  for (const WideInteger part : vector) {
    if (part != 0) return sign_of(part);
  }
  return 0;
}

}  // namespace thinwall
