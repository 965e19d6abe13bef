#include "engine/contact/TriangleCrossing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace thinwall {
namespace {

/// Below zero by so much a barycentric weight is that of an edge: no way between two triangles goes through neither.
constexpr double kOnEdge = 1e-9;

/// Halvings after which a root in a span of one is known to rounding.
constexpr int kHalvings = 60;

double determinant(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return a.dot(b.cross(c));
}

/// Six times the volume between the point and the triangle: a cubic in the time, from 0 to 1.
struct SideCubic {
  std::array<double, 4> terms;  // of rising powers

  double at(double time) const { return terms[0] + time * (terms[1] + time * (terms[2] + time * terms[3])); }

  /// Times between which it rises or falls all along: 0, those at which its slope is zero or else 0, and 1.
  std::array<double, 4> turns() const {
    std::array<double, 4> times = {0, 0, 0, 1};
    const double a = 3 * terms[3], b = 2 * terms[2], c = terms[1], under = b * b - 4 * a * c;
    if (under < 0) return times;
    // Without the difference of two numbers that are nearly the same.
    const double q = -0.5 * (b + std::copysign(std::sqrt(under), b));
    const double one = a != 0 ? q / a : 0, other = q != 0 ? c / q : 0;
    if (one > 0 && one < 1) times[1] = one;
    if (other > 0 && other < 1) times[2] = other;
    if (times[1] > times[2]) std::swap(times[1], times[2]);
    return times;
  }

  /// Of two times between which it changes its sign.
  double root_between(double low, double high) const {
    const bool rises = at(high) > at(low);
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (low + high);
      ((at(middle) > 0) == rises ? high : low) = middle;
    }
    return 0.5 * (low + high);
  }
};

}  // namespace

bool goes_through(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const MovingTriangle& triangle) {
  const Eigen::Vector3d a0 = triangle.from[1] - triangle.from[0], b0 = triangle.from[2] - triangle.from[0];
  const Eigen::Vector3d c0 = from - triangle.from[0];
  const Eigen::Vector3d a1 = triangle.to[1] - triangle.to[0] - a0, b1 = triangle.to[2] - triangle.to[0] - b0;
  const Eigen::Vector3d c1 = to - triangle.to[0] - c0;
  const SideCubic side{
      {determinant(c0, a0, b0), determinant(c1, a0, b0) + determinant(c0, a1, b0) + determinant(c0, a0, b1),
       determinant(c0, a1, b1) + determinant(c1, a0, b1) + determinant(c1, a1, b0), determinant(c1, a1, b1)}};
  const std::array<double, 4> turns = side.turns();
  for (std::size_t k = 1; k < turns.size(); ++k) {
    if (side.at(turns[k - 1]) * side.at(turns[k]) >= 0) continue;
    const double time = side.root_between(turns[k - 1], turns[k]);
    const Eigen::Vector3d a = a0 + time * a1, b = b0 + time * b1, c = c0 + time * c1, normal = a.cross(b);
    const double second = c.cross(b).dot(normal), third = a.cross(c).dot(normal), all = normal.squaredNorm();
    if (std::min({second, third, all - second - third}) >= -kOnEdge * all) return true;
  }
  return false;
}

}  // namespace thinwall
