#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/cutting/LipOpening.hpp"

namespace thinwall {

/// The caps of a wall, kept in step with its rim. A cut that ends at the rim splits the cap's edge there and with it
/// the cap's triangle. Where it opens the rim, the cap's triangles around the doubled vertex are shared out between its
/// two lips, and one more, without rest area, joins the lips with a vertex of the cap: wall, caps and the patch over
/// the wound stay one closed surface.
class CapRim {
 public:
  explicit CapRim(std::vector<Eigen::Vector3i>& caps);

  /// The wall's edge from a to b now is the chain a, m, n, ..., b.
  void split_edge(std::vector<Eigen::Vector3i>& caps, std::span<const int> chain);

  /// Follows the opening of a vertex of the rim.
  void open(std::vector<Eigen::Vector3i>& caps, const RimOpening& rim);

  bool has_edge(int from, int to) const { return edges_.count(key(from, to)) > 0; }
  /// The open edge of the caps that leaves the end of the capped edge from -> to of the wall's border, turning around
  /// `from`; none where the wall's border goes on without a cap.
  std::optional<int> open_edge_from(std::span<const Eigen::Vector3i> caps, int from, int to) const;

 private:
  std::unordered_map<std::uint64_t, int> edges_;  // directed edge of a cap's triangle -> that triangle; look-up only

  static std::uint64_t key(int from, int to) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32 | static_cast<std::uint32_t>(to);
  }
  void add(std::vector<Eigen::Vector3i>& caps, int at, const Eigen::Vector3i& triangle);
  void forget(const std::vector<Eigen::Vector3i>& caps, int at);
};

}  // namespace thinwall
