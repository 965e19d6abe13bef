#include "engine/contact/LipNeighbours.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace thinwall {
namespace {

/// (vertices), the others that have the same place, ascending.
std::vector<std::vector<int>> doubles_of(std::span<const Eigen::Vector3i> triangles, const Eigen::VectorXd& position) {
  const auto place = [&](int v) { return std::array{position[3 * v], position[3 * v + 1], position[3 * v + 2]}; };
  std::vector<std::vector<int>> doubles(position.size() / 3);
  std::vector<int> by_place;
  std::vector<char> is_used(doubles.size(), 0);
  for (const Eigen::Vector3i& triangle : triangles) {
    for (const int v : triangle) {
      if (!std::exchange(is_used[v], 1)) by_place.push_back(v);
    }
  }
  std::ranges::sort(by_place, [&](int a, int b) { return std::pair(place(a), a) < std::pair(place(b), b); });
  for (std::size_t begin = 0, end = 0; begin < by_place.size(); begin = end) {
    for (end = begin + 1; end < by_place.size() && place(by_place[end]) == place(by_place[begin]);) ++end;
    for (std::size_t a = begin; a < end; ++a) {
      for (std::size_t b = begin; b < end; ++b) {
        if (a != b) doubles[by_place[a]].push_back(by_place[b]);
      }
    }
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
