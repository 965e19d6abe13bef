#include "studio/organs/generator/Polygonisation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace thinwall {
namespace {

/// Corners of a cube by their bits: 1 for x, 2 for y, 4 for z. Each tetrahedron runs along the diagonal 0 to 7 and is
/// positively oriented.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 5, 1, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 6, 4, 7}}};

class MarchingTetrahedra {
 public:
  MarchingTetrahedra(const ImplicitBody& body, const Eigen::Vector3d& low, const Eigen::Vector3d& high, double step)
      : body_(body), low_(low), step_(step) {
    for (int axis = 0; axis < 3; ++axis) {
      points_[axis] = static_cast<int>(std::ceil((high[axis] - low[axis]) / step)) + 1;
    }
    values_.reserve(static_cast<std::size_t>(points_[0]) * points_[1] * points_[2]);
    for (int k = 0; k < points_[2]; ++k) {
      for (int j = 0; j < points_[1]; ++j) {
        for (int i = 0; i < points_[0]; ++i) values_.push_back(body_(low_ + step_ * Eigen::Vector3d(i, j, k)).value);
      }
    }
  }

  TriangleSurface run() {
    for (int k = 0; k + 1 < points_[2]; ++k) {
      for (int j = 0; j + 1 < points_[1]; ++j) {
        for (int i = 0; i + 1 < points_[0]; ++i) march_cube(i, j, k);
      }
    }
    return std::move(surface_);
  }

 private:
  int index(int i, int j, int k) const { return (k * points_[1] + j) * points_[0] + i; }

  Eigen::Vector3d position(int grid_point) const {
    const int i = grid_point % points_[0];
    const int j = grid_point / points_[0] % points_[1];
    const int k = grid_point / points_[0] / points_[1];
    return low_ + step_ * Eigen::Vector3d(i, j, k);
  }

  void march_cube(int i, int j, int k) {
    std::array<int, 8> corners{};
    int inside = 0;
    for (int c = 0; c < 8; ++c) {
      corners[c] = index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1));
      if (values_[corners[c]] < 0) ++inside;
    }
    if (inside == 0 || inside == 8) return;
    for (const std::array<int, 4>& t : kTetrahedra) {
      march_tetrahedron({corners[t[0]], corners[t[1]], corners[t[2]], corners[t[3]]});
    }
  }

  void march_tetrahedron(std::array<int, 4> p) {
    // Even permutations bring the corners inside to the front, and what is left of them to the back, without turning
    // the tetrahedron inside out.
    static constexpr std::array<std::array<int, 4>, 12> kEven = {{{0, 1, 2, 3},
                                                                  {0, 2, 3, 1},
                                                                  {0, 3, 1, 2},
                                                                  {1, 0, 3, 2},
                                                                  {1, 2, 0, 3},
                                                                  {1, 3, 2, 0},
                                                                  {2, 0, 1, 3},
                                                                  {2, 1, 3, 0},
                                                                  {2, 3, 0, 1},
                                                                  {3, 0, 2, 1},
                                                                  {3, 1, 0, 2},
                                                                  {3, 2, 1, 0}}};
    std::array<bool, 4> is_inside{};
    int inside = 0;
    for (int c = 0; c < 4; ++c) {
      is_inside[c] = values_[p[c]] < 0;
      inside += is_inside[c] ? 1 : 0;
    }
    if (inside == 0 || inside == 4) return;
    const bool lone_is_inside = inside != 3;
    const int at_front = inside == 2 ? 2 : 1;
    for (const std::array<int, 4>& order : kEven) {
      bool fits = true;
      for (int c = 0; c < 4; ++c) fits = fits && is_inside[order[c]] == ((c < at_front) == lone_is_inside);
      if (!fits) continue;
      const std::array<int, 4> q = {p[order[0]], p[order[1]], p[order[2]], p[order[3]]};
      if (inside == 2) {
        const std::array<int, 4> ring = {crossing(q[0], q[2]), crossing(q[0], q[3]), crossing(q[1], q[3]),
                                         crossing(q[1], q[2])};
        surface_.triangles.emplace_back(ring[0], ring[1], ring[2]);
        surface_.triangles.emplace_back(ring[0], ring[2], ring[3]);
      } else {
        const int a = crossing(q[0], q[1]);
        const int b = crossing(q[0], lone_is_inside ? q[2] : q[3]);
        const int c = crossing(q[0], lone_is_inside ? q[3] : q[2]);
        surface_.triangles.emplace_back(a, b, c);
      }
      return;
    }
  }

  /// The vertex where the surface crosses the line between two grid points.
  int crossing(int a, int b) {
    const std::pair<int, int> key = std::minmax(a, b);
    const auto [entry, is_new] = crossings_.try_emplace(key, static_cast<int>(surface_.vertices.size()));
    if (is_new) {
      const double share = values_[key.first] / (values_[key.first] - values_[key.second]);
      const Eigen::Vector3d start = position(key.first);
      surface_.vertices.push_back(start + share * (position(key.second) - start));
    }
    return entry->second;
  }

  const ImplicitBody& body_;
  Eigen::Vector3d low_;
  double step_;
  std::array<int, 3> points_{};
  std::vector<double> values_;
  std::map<std::pair<int, int>, int> crossings_;
  TriangleSurface surface_;
};

}  // namespace

TriangleSurface polygonise(const ImplicitBody& body, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                           double step) {
  return MarchingTetrahedra(body, low, high, step).run();
}

}  // namespace thinwall
