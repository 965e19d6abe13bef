#include "engine/contact/LipNeighbours.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

namespace thinwall {
namespace {

/// Vertices that triangles use, by their places: those of one place in chains.
class PlaceTable {
 public:
  PlaceTable(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position)
      : position_(position), chain_(position.size() / 3, -1), is_used_(chain_.size(), 0) {
    heads_.assign(std::bit_ceil(2 * chain_.size() + 1), -1);
    for (const Eigen::Vector3i& triangle : triangles) {
      for (const int vertex : triangle) {
        if (!std::exchange(is_used_[vertex], 1)) chain_[vertex] = std::exchange(heads_[slot_of(vertex)], vertex);
      }
    }
  }

  bool is_used(int vertex) const { return is_used_[vertex] != 0; }

  /// The others in the same place, in no order that counts.
  template <typename Visit>
  void visit_doubles(int vertex, const Visit& visit) const {
    for (int other = heads_[slot_of(vertex)]; other >= 0; other = chain_[other]) {
      if (other != vertex && place_of(other) == place_of(vertex)) visit(other);
    }
  }

 private:
  Eigen::Vector3d place_of(int vertex) const { return position_.segment<3>(3 * vertex); }

  std::size_t slot_of(int vertex) const {
    std::uint64_t hash = 0;
    for (const double coordinate : place_of(vertex)) {
      // Zeros of either sign are the same place.
      hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29;
    }
    return hash & (heads_.size() - 1);
  }

  const Eigen::VectorXd& position_;
  std::vector<int> chain_;  // (vertices), the next one of the slot
  std::vector<char> is_used_;
  std::vector<int> heads_;  // of the slots
};

/// (vertices), the others that have the same place, ascending.
std::vector<std::vector<int>> doubles_of(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position) {
  const PlaceTable table(triangles, position);
  std::vector<std::vector<int>> doubles(position.size() / 3);
  for (int vertex = 0; vertex < static_cast<int>(doubles.size()); ++vertex) {
    if (!table.is_used(vertex)) continue;
    table.visit_doubles(vertex, [&](int other) { doubles[vertex].push_back(other); });
    std::ranges::sort(doubles[vertex]);
  }
  return doubles;
}

}  // namespace

std::vector<std::vector<int>> neighbours_across_cuts(std::span<const Eigen::Vector3i> triangles,
                                                     const Eigen::VectorXd& rest_position) {
  const std::vector<std::vector<int>> doubles = doubles_of(triangles, rest_position);
  std::vector<std::vector<int>> across(doubles.size());
  for (const Eigen::Vector3i& triangle : triangles) {
    for (const int lip : triangle) {
      if (doubles[lip].empty()) continue;
      for (const int v : triangle) across[v].insert(across[v].end(), doubles[lip].begin(), doubles[lip].end());
    }
  }
  for (std::vector<int>& one : across) {
    std::ranges::sort(one);
    one.erase(std::unique(one.begin(), one.end()), one.end());
  }
  return across;
}

}  // namespace thinwall
