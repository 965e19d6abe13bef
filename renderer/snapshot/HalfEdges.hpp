#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Which triangle has an edge in a given sense. A vertex has few edges, so that looking through those is quicker than
/// to sort all and search: each cut makes a new topology, often one a picture.
class HalfEdges {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// Of several lists of triangles, counted one after the other.
  explicit HalfEdges(std::initializer_list<std::span<const Triangle>> lists) {
    for (const std::span<const Triangle> triangles : lists) {
      for (const Triangle& triangle : triangles) {
        for (const std::uint32_t vertex : triangle) {
          if (vertex + 2 > first_.size()) first_.resize(vertex + 2, 0);
          ++first_[vertex + 1];
        }
      }
    }
    for (std::size_t vertex = 1; vertex < first_.size(); ++vertex) first_[vertex] += first_[vertex - 1];
    edges_.resize(first_.empty() ? 0 : first_.back());
    std::vector<std::uint32_t> next(first_);
    std::uint32_t count = 0;
    for (const std::span<const Triangle> triangles : lists) {
      for (const Triangle& triangle : triangles) {
        for (std::size_t k = 0; k < 3; ++k) edges_[next[triangle[k]]++] = {triangle[(k + 1) % 3], count};
        ++count;
      }
    }
  }

  /// The first triangle that has the edge from `start` to `end` in this sense; kNone where there is none.
  std::uint32_t triangle_of(std::uint32_t start, std::uint32_t end) const {
    if (start + 1 >= first_.size()) return kNone;
    for (std::uint32_t i = first_[start]; i < first_[start + 1]; ++i) {
      if (edges_[i].end == end) return edges_[i].triangle;
    }
    return kNone;
  }

 private:
  struct Edge {
    std::uint32_t end = 0;
    std::uint32_t triangle = 0;
  };
  std::vector<std::uint32_t> first_;  // (vertices + 1), into `edges_`
  std::vector<Edge> edges_;           // by the vertex where they start, then by triangle
};

}  // namespace thinwall
