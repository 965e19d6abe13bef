#include "engine/cutting/CapRim.hpp"

#include <algorithm>
#include <cassert>

namespace thinwall {
namespace {

/// The vertex that follows `vertex` in a triangle, `steps` corners on.
int following(const Eigen::Vector3i& triangle, int vertex, int steps) {
  for (int k = 0; k < 3; ++k) {
    if (triangle[k] == vertex) return triangle[(k + steps) % 3];
  }
  assert(false);
  return -1;
}

}  // namespace

CapRim::CapRim(std::vector<Eigen::Vector3i>& caps) {
  for (int t = 0; t < static_cast<int>(caps.size()); ++t) add(caps, t, Eigen::Vector3i(caps[t]));
}

void CapRim::add(std::vector<Eigen::Vector3i>& caps, int at, const Eigen::Vector3i& triangle) {
  if (at == static_cast<int>(caps.size())) caps.push_back(triangle);
  caps[at] = triangle;
  for (int k = 0; k < 3; ++k) edges_[key(triangle[k], triangle[(k + 1) % 3])] = at;
}

void CapRim::forget(const std::vector<Eigen::Vector3i>& caps, int at) {
  for (int k = 0; k < 3; ++k) edges_.erase(key(caps[at][k], caps[at][(k + 1) % 3]));
}

void CapRim::split_edge(std::vector<Eigen::Vector3i>& caps, std::span<const int> chain) {
  const auto found = edges_.find(key(chain.back(), chain.front()));
  if (found == edges_.end()) return;
  const int cap = found->second;
  const int c = following(caps[cap], chain.front(), 1);
  forget(caps, cap);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    add(caps, i == 0 ? cap : static_cast<int>(caps.size()), {chain[i + 1], chain[i], c});
  }
}

void CapRim::open(std::vector<Eigen::Vector3i>& caps, const RimOpening& rim) {
  const auto [before, vertex, after, last] = rim;
  const bool capped_before = has_edge(vertex, before), capped_after = has_edge(after, vertex);
  if (!capped_before && !capped_after) return;
  std::vector<int> fan;  // counter-clockwise; from `before` where that side is capped
  if (capped_before) {
    for (auto edge = edges_.find(key(vertex, before)); edge != edges_.end();) {
      fan.push_back(edge->second);
      edge = edges_.find(key(vertex, following(caps[edge->second], vertex, 2)));
    }
  } else {
    for (auto edge = edges_.find(key(after, vertex)); edge != edges_.end();) {
      fan.push_back(edge->second);
      edge = edges_.find(key(following(caps[edge->second], vertex, 1), vertex));
    }
  }
  const bool both = capped_before && capped_after;
  const std::size_t to_last = both ? (fan.size() + 1) / 2 : capped_before ? fan.size() : 0;
  const int joint = both ? following(caps[fan[to_last - 1]], vertex, 2) : -1;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    Eigen::Vector3i triangle = caps[fan[i]];
    forget(caps, fan[i]);
    for (int& corner : triangle) {
      if (corner == vertex && i < to_last) corner = last;
    }
    add(caps, fan[i], triangle);
  }
  if (both) add(caps, static_cast<int>(caps.size()), {last, joint, vertex});
}

std::optional<int> CapRim::open_edge_from(std::span<const Eigen::Vector3i> caps, int from, int to) const {
  for (auto edge = edges_.find(key(to, from)); edge != edges_.end();) {
    const int next = following(caps[edge->second], from, 1);
    edge = edges_.find(key(next, from));
    if (edge == edges_.end()) return next;
  }
  return std::nullopt;
}

}  // namespace thinwall
