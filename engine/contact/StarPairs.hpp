#pragma once

#include <Eigen/Core>
#include <memory>
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
      for (const int pair : star.near) visit((*star.pairs)[pair]);
    }
  }

  /// Fraction of the motion that all the pairs may go without meeting.
  double safe_fraction(const Eigen::VectorXd& position, const Eigen::VectorXd& motion) const;

 private:
  struct Star {
    int center = 0;
    int begin = 0, end = 0;                              // into `ring_`: the vertices joined to the centre
    double margin = 0;                                   // metres
    double slack = 0;                                    // metres, by which pairs that are not near exceed their ranges
    std::shared_ptr<const std::vector<NearPair>> pairs;  // shared with the wall before a cut
    std::vector<int> near = {};                          // into `pairs`
  };

  void append(Star star, std::span<const int> ring);
  void append(const StarPairs& other, const Star& star);
  void measure(const Eigen::VectorXd& position, Star& star);

  std::vector<Star> stars_;
  std::vector<int> ring_;                 // vertices, star by star
  std::vector<Eigen::Vector3d> offsets_;  // (ring), metres, from the centre, when the distances were taken
};

}  // namespace thinwall
