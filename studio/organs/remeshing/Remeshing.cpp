#include "studio/organs/remeshing/Remeshing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "studio/organs/remeshing/EditableSurface.hpp"

namespace thinwall {
namespace {

/// Rounds with splits and collapses: enough for the count and the shape to settle.
constexpr int kRoundsOfCount = 15;

/// Rounds that only turn edges and move vertices.
constexpr int kRoundsOfShape = 10;

/// Height over longest edge of a triangle that vertices may not be moved into: half a degree.
constexpr double kLeastHeight = 0.01;

class Remesher {
 public:
  Remesher(const TriangleSurface& start, const SurfaceToFollow& target, const RemeshingOptions& options)
      : surface_(start), target_(target), options_(options), features_(options.features) {}

  TriangleSurface run() {
    const bool counts = options_.edge_length <= 0;
    unit_ = counts ? std::sqrt(4 / std::sqrt(3.0) * weighted_area() / options_.triangles) : options_.edge_length;
    for (int round = 0; round < kRoundsOfCount; ++round) {
      split_long_edges();
      collapse_short_edges();
      even_out();
      const double ratio = static_cast<double>(surface_.triangle_count()) / options_.triangles;
      // The first rounds are far from settled: their count says little about the length.
      if (counts && round >= 5) unit_ *= std::sqrt(ratio);
    }
    if (counts) meet_count();
    for (int round = 0; round < kRoundsOfShape; ++round) even_out();
    for (int round = 0; round < kRoundsOfShape; ++round) {
      turn_for_angles();
      move_along_surface();
    }
    return surface_.compact();
  }

 private:
  using Edge = std::array<int, 2>;

  double wanted_length(const Eigen::Vector3d& point) const { return unit_ * options_.relative_edge_length(point); }

  /// Area measured in squares of the relative edge length.
  double weighted_area() const {
    double sum = 0;
    const TriangleSurface all = surface_.compact();
    for (const Eigen::Vector3i& t : all.triangles) {
      const Eigen::Vector3d& a = all.vertices[t[0]];
      const Eigen::Vector3d& b = all.vertices[t[1]];
      const Eigen::Vector3d& c = all.vertices[t[2]];
      const double relative = options_.relative_edge_length((a + b + c) / 3);
      sum += 0.5 * (b - a).cross(c - a).norm() / (relative * relative);
    }
    return sum;
  }

  /// Length of an edge in wanted lengths.
  double relative_length(int a, int b) const {
    const Eigen::Vector3d& p = surface_.positions[a];
    const Eigen::Vector3d& q = surface_.positions[b];
    return (p - q).norm() / wanted_length((p + q) / 2);
  }

  Eigen::Vector3d middle(int a, int b) const {
    if (features_.has_edge(a, b)) return middle_on_line(a, b, features_.line_of(a, b));
    const Eigen::Vector3d halfway = (surface_.positions[a] + surface_.positions[b]) / 2;
    return target_.project(halfway, (mean_normal(a) + mean_normal(b)).normalized());
  }

  /// Normal of a vertex: of its triangles by their area.
  Eigen::Vector3d mean_normal(int v) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int t : surface_.triangles_at(v)) {
      const Eigen::Vector3i& c = surface_.triangle(t);
      const Eigen::Vector3d& p = surface_.positions[c[0]];
      sum += (surface_.positions[c[1]] - p).cross(surface_.positions[c[2]] - p);
    }
    return sum.normalized();
  }

  void split(int a, int b) {
    const int added = surface_.split(a, b, middle(a, b));
    features_.split(a, b, added);
  }

  void split_long_edges() {
    for (const auto& [a, b] : surface_.edges()) {
      if (surface_.has_edge(a, b) && relative_length(a, b) > 4.0 / 3) split(a, b);
    }
  }

  void collapse_short_edges() {
    for (const auto& [a, b] : surface_.edges()) {
      if (surface_.has_edge(a, b) && relative_length(a, b) < 4.0 / 5) try_collapse(a, b, 4.0 / 3);
    }
  }

  /// 0 inside the surface, 1 on a feature line, 2 at a corner.
  int rank(int v) const { return features_.is_corner(v) ? 2 : features_.is_on_line(v) ? 1 : 0; }

  /// Whether merging the ends of an edge keeps the feature lines.
  bool keeps_features(int a, int b) const {
    if (rank(a) == 0 || rank(b) == 0) return true;
    if (rank(a) == 2 && rank(b) == 2) return false;
    if (!features_.has_edge(a, b)) return false;
    // A closed line keeps three edges.
    return std::ranges::none_of(features_.neighbours(a), [&](int v) { return features_.has_edge(v, b); });
  }

  /// Collapses an edge unless a feature would be lost, a triangle turn over or an edge become longer than `longest`
  /// wanted lengths.
  bool try_collapse(int first, int second, double longest) {
    if (!surface_.may_collapse(first, second) || !keeps_features(first, second)) return false;
    // What is bound more stays.
    const int a = rank(first) >= rank(second) ? first : second;
    const int b = first + second - a;
    const Eigen::Vector3d target = rank(a) > rank(b) ? surface_.positions[a] : middle(first, second);
    for (const auto& [moved, other] : {Edge{a, b}, Edge{b, a}}) {
      for (const int t : surface_.triangles_at(moved)) {
        const Eigen::Vector3i& corners = surface_.triangle(t);
        if ((corners.array() == other).any()) continue;
        if (!stays_upright(corners, moved, target)) return false;
        for (const int v : corners) {
          if (v == moved) continue;
          const double length = (surface_.positions[v] - target).norm();
          if (length > longest * wanted_length((surface_.positions[v] + target) / 2)) return false;
        }
      }
    }
    surface_.collapse(a, b, target);
    features_.collapse(a, b);
    return true;
  }

  bool stays_upright(const Eigen::Vector3i& corners, int moved, const Eigen::Vector3d& target) const {
    std::array<Eigen::Vector3d, 3> before;
    std::array<Eigen::Vector3d, 3> after;
    for (int k = 0; k < 3; ++k) {
      before[k] = surface_.positions[corners[k]];
      after[k] = corners[k] == moved ? target : before[k];
    }
    const Eigen::Vector3d old_normal = (before[1] - before[0]).cross(before[2] - before[0]);
    const Eigen::Vector3d new_normal = (after[1] - after[0]).cross(after[2] - after[0]);
    return new_normal.dot(old_normal) > 0.5 * new_normal.norm() * old_normal.norm();
  }

  /// Splits the longest or collapses the shortest edges until the count is met.
  void meet_count() {
    while (surface_.triangle_count() + 2 <= options_.triangles) {
      const std::vector<Edge> edges = by_length();
      split(edges.back()[0], edges.back()[1]);
    }
    while (surface_.triangle_count() > options_.triangles) {
      const std::vector<Edge> edges = by_length();
      const auto collapsed =
          std::find_if(edges.begin(), edges.end(), [&](const Edge& e) { return try_collapse(e[0], e[1], 2); });
      if (collapsed == edges.end()) return;
    }
  }

  std::vector<Edge> by_length() const {
    std::vector<Edge> edges = surface_.edges();
    std::vector<std::pair<double, Edge>> keyed;
    for (const Edge& e : edges) keyed.emplace_back(relative_length(e[0], e[1]), e);
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t i = 0; i < keyed.size(); ++i) edges[i] = keyed[i].second;
    return edges;
  }

  void even_out() {
    turn_for_valence();
    for (int i = 0; i < 2; ++i) move_along_surface();
  }

  /// Turns edges where that brings the four vertices nearer to six neighbours each.
  void turn_for_valence() {
    for (const auto& [a, b] : surface_.edges()) {
      if (!surface_.has_edge(a, b) || features_.has_edge(a, b) || !surface_.may_turn(a, b)) continue;
      const std::array<int, 2> far = surface_.far_corners(a, b);
      const auto excess = [&](int v, int change) {
        const int wanted = features_.is_on_line(v) && surface_.is_at_border(v) ? 3 : 6;
        return std::abs(surface_.valence(v) + change - wanted);
      };
      const int before = excess(a, 0) + excess(b, 0) + excess(far[0], 0) + excess(far[1], 0);
      const int after = excess(a, -1) + excess(b, -1) + excess(far[0], 1) + excess(far[1], 1);
      if (after < before && turned_is_upright(a, b, far)) surface_.turn(a, b);
    }
  }

  /// Turns edges where that makes the smallest of the angles at hand larger.
  void turn_for_angles() {
    for (const auto& [a, b] : surface_.edges()) {
      if (!surface_.has_edge(a, b) || features_.has_edge(a, b) || !surface_.may_turn(a, b)) continue;
      const std::array<int, 2> far = surface_.far_corners(a, b);
      const double before = std::max(largest_cosine(a, b, far[0]), largest_cosine(b, a, far[1]));
      const double after = std::max(largest_cosine(a, far[1], far[0]), largest_cosine(far[1], b, far[0]));
      // The margin keeps edges of a square from turning to and fro.
      if (after < before - 1e-6 && turned_is_upright(a, b, far)) surface_.turn(a, b);
    }
  }

  /// Cosine of a triangle's smallest angle: the arc cosine itself may differ in the last bit from machine to machine.
  double largest_cosine(int a, int b, int c) const {
    const std::array<int, 3> corners = {a, b, c};
    double largest = -1;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d u = surface_.positions[corners[(k + 1) % 3]] - surface_.positions[corners[k]];
      const Eigen::Vector3d v = surface_.positions[corners[(k + 2) % 3]] - surface_.positions[corners[k]];
      largest = std::max(largest, u.dot(v) / (u.norm() * v.norm()));
    }
    return largest;
  }

  Eigen::Vector3d normal(int a, int b, int c) const {
    const Eigen::Vector3d& p = surface_.positions[a];
    return (surface_.positions[b] - p).cross(surface_.positions[c] - p).normalized();
  }

  /// Both new triangles face as the two old ones do together.
  bool turned_is_upright(int a, int b, const std::array<int, 2>& far) const {
    const Eigen::Vector3d old_normal = (normal(a, b, far[0]) + normal(b, a, far[1])).normalized();
    return normal(a, far[1], far[0]).dot(old_normal) > 0.7 && normal(far[1], b, far[0]).dot(old_normal) > 0.7;
  }

  /// Moves each vertex along the surface towards the middle of its triangles, weighted by their area in squares of the
  /// wanted length.
  void move_along_surface() {
    std::vector<Eigen::Vector3d> moved = surface_.positions;
    for (int v = 0; v < static_cast<int>(moved.size()); ++v) {
      if (surface_.triangles_at(v).empty() || rank(v) == 2) continue;
      if (rank(v) == 1) {
        moved[v] = middle_of_line(v);
        continue;
      }
      const Eigen::Vector3d here = surface_.positions[v];
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      double weights = 0;
      for (const int t : surface_.triangles_at(v)) {
        const Eigen::Vector3i& c = surface_.triangle(t);
        const Eigen::Vector3d& p = surface_.positions[c[0]];
        const Eigen::Vector3d& q = surface_.positions[c[1]];
        const Eigen::Vector3d& r = surface_.positions[c[2]];
        const Eigen::Vector3d centre = (p + q + r) / 3;
        const double length = wanted_length(centre);
        const double weight = (q - p).cross(r - p).norm() / (length * length);
        sum += weight * centre;
        weights += weight;
      }
      const Eigen::Vector3d mesh_normal = mean_normal(v);
      const Eigen::Vector3d up = target_.normal(here, mesh_normal);
      const Eigen::Vector3d step = sum / weights - here;
      moved[v] = target_.project(here + step - step.dot(up) * up, mesh_normal);
    }
    std::swap(surface_.positions, moved);
    put_back_from_flat(moved);
  }

  /// Height over longest edge of a triangle.
  static double height_of(const Eigen::Vector3i& corners, const std::vector<Eigen::Vector3d>& positions) {
    const Eigen::Vector3d& a = positions[corners[0]];
    const Eigen::Vector3d& b = positions[corners[1]];
    const Eigen::Vector3d& c = positions[corners[2]];
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
  }

  /// Puts vertices back of triangles that their moves have flattened, as where several came to lie on one peak.
  void put_back_from_flat(const std::vector<Eigen::Vector3d>& before) {
    for (bool again = true; again;) {
      again = false;
      for (int v = 0; v < static_cast<int>(before.size()); ++v) {
        for (const int t : surface_.triangles_at(v)) {
          const Eigen::Vector3i& corners = surface_.triangle(t);
          const double height = height_of(corners, surface_.positions);
          if (height >= kLeastHeight || height >= height_of(corners, before)) continue;
          for (const int corner : corners) {
            again = again || surface_.positions[corner] != before[corner];
            surface_.positions[corner] = before[corner];
          }
        }
      }
    }
  }

  /// Halfway along its line between the vertices beside one.
  Eigen::Vector3d middle_of_line(int v) const {
    const std::vector<int>& beside = features_.neighbours(v);
    return middle_on_line(beside.front(), beside.back(), features_.line_of(v, beside.front()));
  }

  Eigen::Vector3d middle_on_line(int a, int b, int line) const {
    const Eigen::Vector3d& p = surface_.positions[a];
    const Eigen::Vector3d& q = surface_.positions[b];
    return features_.project((p + q) / 2, q - p, line);
  }

  EditableSurface surface_;
  const SurfaceToFollow& target_;
  const RemeshingOptions& options_;
  FeatureLines features_;
  double unit_ = 0;  // wanted edge length where the relative one is 1, metres
};

}  // namespace

TriangleSurface remesh(const TriangleSurface& start, const SurfaceToFollow& target, const RemeshingOptions& options) {
  return Remesher(start, target, options).run();
}

}  // namespace thinwall
