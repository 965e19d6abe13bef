#include <algorithm>
#include <cassert>

#include "engine/contact/SelfContact.hpp"

namespace thinwall {

std::vector<char> SelfContact::has_changed_since(const SelfContact& before) const {
  assert(triangles_.size() >= before.triangles_.size() && held_.size() >= before.held_.size());
  assert(edge_length_ == before.edge_length_ && placement_.size() == rest_position_.size());
  std::vector<char> changed(held_.size(), 0);
  const auto mark = [&](const Eigen::Vector3i& triangle) {
    for (const int vertex : triangle) changed[vertex] = 1;
  };
  for (std::size_t t = 0; t < before.triangles_.size(); ++t) {
    if (triangles_[t] == before.triangles_[t]) continue;
    mark(triangles_[t]);
    mark(before.triangles_[t]);
  }
  for (std::size_t t = before.triangles_.size(); t < triangles_.size(); ++t) mark(triangles_[t]);
  const std::size_t vertices = before.held_.size();
  std::fill(changed.begin() + static_cast<std::ptrdiff_t>(vertices), changed.end(), 1);
  for (std::size_t v = 0; v < vertices; ++v) {
    const Eigen::Index k = 3 * static_cast<Eigen::Index>(v);
    const bool is_same = rest_position_.segment<3>(k) == before.rest_position_.segment<3>(k) &&
                         held_[v] == before.held_[v] && vertex_area_[v] == before.vertex_area_[v] &&
                         vertex_thickness_[v] == before.vertex_thickness_[v] &&
                         vertex_shrink_[v] == before.vertex_shrink_[v] && margins_[v] == before.margins_[v];
    if (!is_same || before.left_alone_[v]) changed[v] = 1;
  }
  return changed;
}

void SelfContact::carry_list(const SelfContact& before) {
  if (before.listings_ == 0) return;
  listings_ = before.listings_;
  // Those of changed parts go when the next listing finds their vertices new.
  near_ = before.near_;
  const Eigen::Vector3d drift = before.drift_to(placement_);
  listed_position_ = placement_ - drift.replicate(placement_.size() / 3, 1);
  for (std::size_t v = 0; v < before.held_.size(); ++v) {
    const Eigen::Index k = 3 * static_cast<Eigen::Index>(v);
    if (!is_new_[v]) listed_position_.segment<3>(k) = before.listed_position_.segment<3>(k);
  }
}

}  // namespace thinwall
