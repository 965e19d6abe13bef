#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace thinwall {

/// Numbers from 0 on in sets that grow together; the lowest member stands for each (union by index, paths halved).
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  void join(int one, int other) {
    one = find(one);
    other = find(other);
    parent_[std::max(one, other)] = std::min(one, other);
  }
  void join(const Eigen::Vector3i& triangle) {
    join(triangle[0], triangle[1]);
    join(triangle[0], triangle[2]);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace thinwall
