#include "engine/contact/SelfIntersections.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/TriangleTree.hpp"

namespace thinwall {
namespace {

/// Part of a triangle by which an edge may pass beside it: what passes between two triangles, as symmetric surfaces do,
/// passes through one of them, whatever round-off says.
constexpr double kBeside = 1e-6;

double volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  return (b - a).cross(c - a).dot(d - a);
}

class IntersectionSearch {
 public:
  IntersectionSearch(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position)
      : triangles_(triangles), position_(position) {}

  /// Adds the edges of one triangle that pass through another.
  void add(int triangle, int other, std::vector<SurfaceIntersection>& found) const {
    const Eigen::Vector3i& corners = triangles_[other];
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({triangles_[triangle][k], triangles_[triangle][(k + 1) % 3]});
      if ((corners.array() == low || corners.array() == high).any()) continue;
      if (!passes_through({at(low), at(high)}, {at(corners[0]), at(corners[1]), at(corners[2])})) continue;
      found.push_back({.edge = {low, high}, .triangle = other});
    }
  }

 private:
  Eigen::Vector3d at(int vertex) const { return position_.segment<3>(3 * vertex); }

  std::span<const Eigen::Vector3i> triangles_;
  const Eigen::VectorXd& position_;
};

}  // namespace

bool passes_through(const std::array<Eigen::Vector3d, 2>& edge, const std::array<Eigen::Vector3d, 3>& triangle) {
  const auto& [p, q] = edge;
  const auto& [a, b, c] = triangle;
  if (volume(a, b, c, p) * volume(a, b, c, q) >= 0) return false;
  const double one = volume(p, q, a, b), two = volume(p, q, b, c), three = volume(p, q, c, a);
  const double whole = one + two + three, least = -kBeside * std::abs(whole), sign = whole > 0 ? 1 : -1;
  return sign * one >= least && sign * two >= least && sign * three >= least;
}

std::vector<SurfaceIntersection> self_intersections(std::span<const Eigen::Vector3i> triangles,
                                                    const Eigen::VectorXd& position) {
  const std::vector<double> margins(static_cast<std::size_t>(position.size() / 3), 0.0);
  const TriangleTree tree(triangles, position, margins);
  const IntersectionSearch search(triangles, position);
  std::vector<std::vector<SurfaceIntersection>> by_task;
  tree.visit_near(
      0, 0, [&](std::size_t tasks) { by_task.resize(tasks); },
      [&](std::size_t task, int triangle, int other, double) {
        search.add(triangle, other, by_task[task]);
        search.add(other, triangle, by_task[task]);
      });
  std::vector<SurfaceIntersection> found;
  for (const auto& some : by_task) found.insert(found.end(), some.begin(), some.end());
  // Both triangles at an edge have found it.
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace thinwall
