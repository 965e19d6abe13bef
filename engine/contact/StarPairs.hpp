#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/contact/NearPair.hpp"

namespace thinwall {

/// Pairs of parts of triangles that share a vertex, gathered by that vertex. They are always close, so that a search by
/// place would find them all every time; but they meet only where the wall crumples, and how far the vertices of a star
/// move relative to its centre bounds by how much any of their distances changes. So the distances of a star are taken
/// anew only when it has changed its shape by what was left.
class StarPairs {
 public:
  StarPairs() = default;

  /// `pairs`: (vertices), of the triangles around each of them. Pairs nearer than range + `margins` (vertices, metres)
  /// are kept in view. `position`: (3 vertices), metres.
  StarPairs(std::span<const Eigen::Vector3i> triangles, std::vector<std::vector<NearPair>> pairs,
            std::span<const double> margins, const Eigen::VectorXd& position);

  /// Takes the stars over that another has at vertices that are not named, and that this one has not; `without`:
  /// (vertices), those of the other first.
  void keep(const StarPairs& other, std::span<const char> without);

  /// Finds out which pairs are near; the others are out of range at this position.
  void refresh(const Eigen::VectorXd& position);

  /// Near pairs, by vertex.
  template <typename Visit>
  void visit_near(const Visit& visit) const {
    for (const Star& star : stars_) {
      for (const int pair : star.near) visit(star.pairs[pair]);
    }
  }

  /// Fraction of the motion that all the pairs may go without meeting.
  double safe_fraction(const Eigen::VectorXd& position, const Eigen::VectorXd& motion) const;

 private:
  struct Star {
    int center = 0;
    double margin = 0;                     // metres
    std::vector<int> ring;                 // vertices joined to the centre
    std::vector<Eigen::Vector3d> offsets;  // (ring), metres, from the centre, when the distances were taken
    std::vector<NearPair> pairs;
    std::vector<int> near;  // into `pairs`
    double slack = 0;       // metres, by which the distances of the others exceed their ranges at least
  };

  void measure(const Eigen::VectorXd& position, Star& star) const;

  std::vector<Star> stars_;
};

}  // namespace thinwall
