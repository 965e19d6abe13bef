#include "engine/cutting/PathInsertion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "engine/cutting/CutQuality.hpp"

namespace thinwall {
namespace {

constexpr double kOnLine = 1e-9;       // sine of an angle: nearer points lie on a line
constexpr double kStillWide = 0.9986;  // cosine of 3 degrees: moves that leave less are not made
constexpr double kTakeOver = 0.45;     // edge lengths: how far a free vertex may move to become a node
constexpr double kAttraction = 0.2;    // edge lengths: vertices that near to a segment are put on the path

class Inserter {
 public:
  Inserter(CutPatch& patch, std::span<const PathNode> nodes) : patch_(patch), nodes_(nodes) {}

  InsertedPath insert() {
    InsertedPath path;
    for (const PathNode& node : nodes_) {
      const int vertex = vertex_for(node.place);
      path.node_vertices.push_back(vertex);
      if (vertex >= 0) {
        patch_.freedom[vertex] = VertexFreedom::kFixed;
        continue;
      }
      path.troubled_node = static_cast<int>(path.node_vertices.size()) - 1;
      return path;
    }
    if (nodes_.empty()) return path;
    path.vertices.push_back(path.node_vertices.front());
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      if (route(path.node_vertices[i], path.node_vertices[i + 1], nodes_[i].facet, path.vertices, 0)) continue;
      path.troubled_node = static_cast<int>(i);
      return path;
    }
    path.complete = true;
    return path;
  }

 private:
  CutPatch& patch_;
  std::span<const PathNode> nodes_;
  std::map<std::pair<int, int>, std::vector<int>> side_vertices_;  // original edge -> vertices along it

  int vertex_for(const PatchPlace& place) {
    if (place.kind == PlaceKind::kVertex) return place.vertex;
    return place.kind == PlaceKind::kSide ? vertex_on_side(place) : vertex_in_face(place);
  }

  int vertex_on_side(const PatchPlace& place) {
    std::vector<int>& chain = side_vertices_[std::minmax(place.from, place.to)];
    if (chain.empty()) chain = {std::min(place.from, place.to), std::max(place.from, place.to)};
    // Vertices may have slid along the edge, so the place is found among where they are now.
    const Eigen::Vector3d start = patch_.positions[chain.front()];
    const Eigen::Vector3d along = (patch_.positions[chain.back()] - start).normalized();
    const auto way_to = [&](const Eigen::Vector3d& position) { return along.dot(position - start); };
    std::size_t i = 0;
    while (i + 2 < chain.size() && way_to(patch_.positions[chain[i + 1]]) < way_to(place.position)) ++i;
    const int first = chain[i], second = chain[i + 1];
    PatchCorner side = patch_.side_between(first, second);
    if (side.triangle < 0) side = patch_.side_between(second, first);
    if (side.triangle < 0 || !may_split(side)) return -1;
    const double to_first = way_to(place.position) - way_to(patch_.positions[first]);
    const double to_second = way_to(patch_.positions[second]) - way_to(place.position);
    const double least = 0.9 * kLeastPart * std::min(to_first + to_second, patch_.scale[side.triangle]);
    if (std::min(to_first, to_second) < least) {
      const int near_end = to_first < to_second ? first : second;
      if (patch_.freedom[near_end] == VertexFreedom::kLine) move_to(near_end, place.position);
      return near_end;
    }
    const int vertex = patch_.split_side(side.triangle, side.corner, place.position);
    chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(i) + 1, vertex);
    return vertex;
  }

  bool may_split(const PatchCorner& side) const {
    const int across = patch_.neighbours[side.triangle][side.corner];
    return !patch_.frozen[side.triangle] && across != CutPatch::kFrame && (across < 0 || !patch_.frozen[across]);
  }

  int vertex_in_face(const PatchPlace& place) {
    const auto [triangle, weights] = patch_.locate(place.facet, place.position);
    if (triangle < 0 || patch_.frozen[triangle]) return -1;
    const int taken = take_over(triangle, place.position);
    if (taken >= 0) return taken;
    int side = 0;
    weights.minCoeff(&side);
    side = (side + 1) % 3;  // opposite the corner of least weight
    constexpr double kNearSide = 0.1;
    if (weights.minCoeff() < kNearSide && !patch_.is_held(triangle, side)) {
      return patch_.split_side(triangle, side, place.position);
    }
    if (weights.minCoeff() <= 1e-6) return -1;
    return patch_.split_triangle(triangle, place.position);
  }

  /// A vertex of the triangle that becomes the node: a free one that can move there, or a fixed one that is close.
  int take_over(int triangle, const Eigen::Vector3d& position) {
    int nearest = -1;
    double least = kTakeOver * patch_.scale[triangle];
    for (const int vertex : patch_.triangles[triangle]) {
      const double distance = (patch_.positions[vertex] - position).norm();
      const double reach = patch_.freedom[vertex] == VertexFreedom::kFree ? 1 : kClearance / kTakeOver;
      if (distance / reach >= least) continue;
      least = distance / reach;
      nearest = vertex;
    }
    if (nearest < 0 || patch_.freedom[nearest] != VertexFreedom::kFree) return nearest;
    return move_to(nearest, position) ? nearest : -1;
  }

  bool move_to(int vertex, const Eigen::Vector3d& position) {
    const PatchFan fan = patch_.fan_of(vertex);
    if (fan.cut_off) return false;
    for (const PatchCorner& corner : fan.corners) {
      if (patch_.frozen[corner.triangle]) return false;
    }
    const Eigen::Vector3d before = patch_.positions[vertex];
    patch_.positions[vertex] = position;
    if (sharpness_around(patch_, vertex) > kStillWide) {
      patch_.positions[vertex] = before;
      return false;
    }
    for (const PatchCorner& corner : fan.corners) patch_.changed[corner.triangle] = 1;
    return true;
  }

  /// The vertex of a facet closest to the inner part of a segment, or -1.
  int vertex_near(int u, int v, int facet) const {
    const Eigen::Vector3d begin = patch_.positions[u], along = patch_.positions[v] - begin;
    int nearest = -1;
    double least = 1;
    for (int t = 0; t < patch_.triangle_count(); ++t) {
      if (patch_.facet[t] != facet || patch_.frozen[t]) continue;
      for (const int w : patch_.triangles[t]) {
        if (w == u || w == v) continue;
        const Eigen::Vector3d off = patch_.positions[w] - begin;
        const double part = off.dot(along) / along.squaredNorm();
        const double least_part = kLeastPart * patch_.scale[t] / along.norm();
        if (part < least_part || part > 1 - least_part) continue;
        const double distance = (off - part * along).norm() / (kAttraction * patch_.scale[t]);
        if (distance >= least) continue;
        least = distance;
        nearest = w;
      }
    }
    return nearest;
  }

  /// Brings the segment from u to v into the patch, by way of vertices that lie close to it.
  bool route(int u, int v, int facet, std::vector<int>& path, int depth) {
    constexpr int kDeepest = 6;
    if (u == v) return true;
    const int w = depth < kDeepest && !patch_.are_joined(u, v) ? vertex_near(u, v, facet) : -1;
    if (w < 0) return insert_segment(u, v, facet, path, 0);
    if (patch_.freedom[w] == VertexFreedom::kFree) {
      const Eigen::Vector3d begin = patch_.positions[u];
      const Eigen::Vector3d along = (patch_.positions[v] - begin).normalized();
      move_to(w, begin + along.dot(patch_.positions[w] - begin) * along);
    }
    patch_.freedom[w] = VertexFreedom::kFixed;
    return route(u, w, facet, path, depth + 1) && route(w, v, facet, path, depth + 1);
  }

  bool add_edge(int u, int v, std::vector<int>& path) {
    PatchCorner side = patch_.side_between(u, v);
    if (side.triangle < 0) side = patch_.side_between(v, u);
    if (side.triangle < 0) return false;
    if (!CutPatch::is_open(patch_.neighbours[side.triangle][side.corner])) {
      if (!may_split(side)) return false;
      patch_.set_on_path(u, v);
    }
    path.push_back(v);
    return true;
  }

  /// Where a segment leaves u: along an edge to a vertex on it, or through the side opposite u.
  struct Departure {
    int vertex = -1;
    PatchCorner side;
  };

  Departure depart(int u, int v, int facet) const {
    const auto& p = patch_.positions;
    const double length = (p[v] - p[u]).norm();
    for (const PatchCorner& corner : patch_.fan_of(u).corners) {
      if (patch_.facet[corner.triangle] != facet) continue;
      const Eigen::Vector3i& t = patch_.triangles[corner.triangle];
      const int x = t[(corner.corner + 1) % 3], y = t[(corner.corner + 2) % 3];
      for (const int end : {x, y}) {
        const Eigen::Vector3d edge = p[end] - p[u];
        const double reach = edge.norm();
        const bool same_sense = edge.dot(p[v] - p[u]) > 0 && reach < length * (1 + kOnLine);
        if (same_sense && std::abs(patch_.orientation(facet, p[u], p[end], p[v])) <= kOnLine * reach * length) {
          return {.vertex = end, .side = {}};
        }
      }
      if (patch_.orientation(facet, p[u], p[x], p[v]) > 0 && patch_.orientation(facet, p[u], p[v], p[y]) > 0) {
        return {.vertex = -1, .side = {corner.triangle, (corner.corner + 1) % 3}};
      }
    }
    return {};
  }

  bool insert_segment(int u, int v, int facet, std::vector<int>& path, int depth) {
    constexpr int kDeepest = 100;
    if (depth > kDeepest) return false;
    if (u == v) return true;
    if (patch_.are_joined(u, v)) return add_edge(u, v, path);
    const Departure departure = depart(u, v, facet);
    if (departure.vertex >= 0) {
      return add_edge(u, departure.vertex, path) && insert_segment(departure.vertex, v, facet, path, depth + 1);
    }
    if (departure.side.triangle < 0) return false;
    std::deque<std::pair<int, int>> crossed;
    PatchCorner side = departure.side;
    const auto& p = patch_.positions;
    for (;;) {
      const int x = patch_.triangles[side.triangle][side.corner];
      const int y = patch_.triangles[side.triangle][(side.corner + 1) % 3];
      if (patch_.is_crease(side.triangle, side.corner) || !may_split(side)) return false;
      if (patch_.on_path[side.triangle][side.corner]) return split_and_go_on(side, u, v, facet, path, depth);
      crossed.emplace_back(x, y);
      const int across = patch_.neighbours[side.triangle][side.corner];
      const int corner = patch_.corner_of(across, y);  // the side from y to x
      const int d = patch_.triangles[across][(corner + 2) % 3];
      if (d == v) break;
      const double turn = patch_.orientation(facet, p[u], p[v], p[d]);
      if (std::abs(turn) <= kOnLine * (p[v] - p[u]).norm() * (p[d] - p[u]).norm()) {
        return insert_segment(u, d, facet, path, depth + 1) && insert_segment(d, v, facet, path, depth + 1);
      }
      // x is to the right of the segment and y to its left; d decides which of xd and dy is next.
      side = turn > 0 ? PatchCorner{across, (corner + 1) % 3} : PatchCorner{across, (corner + 2) % 3};
    }
    return flip_away(crossed, u, v, facet) && add_edge(u, v, path);
  }

  /// The segment crosses an edge of the path: the two share a vertex from now on.
  bool split_and_go_on(const PatchCorner& side, int u, int v, int facet, std::vector<int>& path, int depth) {
    const int x = patch_.triangles[side.triangle][side.corner];
    const int y = patch_.triangles[side.triangle][(side.corner + 1) % 3];
    const auto& p = patch_.positions;
    const double of_x = patch_.orientation(facet, p[u], p[v], p[x]), of_y = patch_.orientation(facet, p[u], p[v], p[y]);
    const double part = of_x / (of_x - of_y);
    constexpr double kNearEnd = 0.25;
    int w = part < kNearEnd ? x : y;
    if (part >= kNearEnd && part <= 1 - kNearEnd) {
      w = patch_.split_side(side.triangle, side.corner, p[x] + part * (p[y] - p[x]));
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const bool split = (path[i] == x && path[i + 1] == y) || (path[i] == y && path[i + 1] == x);
        if (split) path.insert(path.begin() + static_cast<std::ptrdiff_t>(i) + 1, w);
      }
    }
    return insert_segment(u, w, facet, path, depth + 1) && insert_segment(w, v, facet, path, depth + 1);
  }

  /// Flips edges that cross the segment until none does.
  bool flip_away(std::deque<std::pair<int, int>>& crossed, int u, int v, int facet) {
    const auto& p = patch_.positions;
    std::size_t idle = 0;
    while (!crossed.empty()) {
      const auto [a, b] = crossed.front();
      crossed.pop_front();
      const PatchCorner side = patch_.side_between(a, b);
      if (side.triangle < 0) return false;
      if (!patch_.can_flip(side.triangle, side.corner)) {
        crossed.emplace_back(a, b);
        if (++idle > crossed.size()) return false;
        continue;
      }
      idle = 0;
      const int n = patch_.neighbours[side.triangle][side.corner];
      const int c = patch_.triangles[side.triangle][(side.corner + 2) % 3];
      const int d = patch_.triangles[n][(patch_.corner_of(n, b) + 2) % 3];
      patch_.flip(side.triangle, side.corner);
      if (c == u || c == v || d == u || d == v) continue;
      const double of_c = patch_.orientation(facet, p[u], p[v], p[c]);
      const double of_d = patch_.orientation(facet, p[u], p[v], p[d]);
      if ((of_c > 0) != (of_d > 0)) crossed.emplace_back(c, d);
    }
    return true;
  }
};

}  // namespace

InsertedPath insert_path(CutPatch& patch, std::span<const PathNode> nodes) {
  return Inserter(patch, nodes).insert();
}

bool drop_closed_edges(CutPatch& patch) {
  const auto stays_single = [&](int vertex) {
    const PatchFan fan = patch.fan_of(vertex);
    int count = 0;
    for (const PatchCorner& corner : fan.corners) count += patch.on_path[corner.triangle][corner.corner] != 0;
    return fan.closed && count == 1;
  };
  bool left = false;
  for (int t = 0; t < patch.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (!patch.on_path[t][k]) continue;
      const int a = patch.triangles[t][k], b = patch.triangles[t][(k + 1) % 3];
      if (!stays_single(a) || !stays_single(b)) {
        left = true;
        continue;
      }
      patch.on_path[t][k] = 0;
      const int across = patch.neighbours[t][k];
      patch.on_path[across][patch.corner_of(across, b)] = 0;
    }
  }
  return left;
}

}  // namespace thinwall
