#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/contact/FoldPotential.hpp"
#include "engine/contact/NearPair.hpp"
#include "engine/contact/StarPairs.hpp"
#include "engine/contact/TriangleTree.hpp"
#include "engine/mesh/SurfaceMesh.hpp"

namespace thinwall {

/// A plane that the wall may not pass, for all vertices that lie above it in the stress-free shape.
struct FloorPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit, towards the wall
  double height = 0;                                  // metres, of the plane along the normal
};

/// What the contact of a wall with itself and with its floor needs to know, all of the given shape.
struct SelfContactDefinition {
  std::span<const Eigen::Vector3i> triangles;  // of the wall
  Eigen::VectorXd position;                    // (3 vertices), metres
  std::span<const double> thickness;           // (triangles), metres
  std::span<const char> fixed;                 // (3 vertices), unknowns that do not move
  std::vector<FloorPlane> floors;
  double pressure = 1;  // pascal, of the potentials: the scale at which two parts lie on each other at half the range
  Eigen::VectorXd placement = {};    // (3 vertices) or none, metres, where the wall is after a cut
  double edge_length = 0;            // metres, by which ranges are measured; 0: the mean of the mesh
  std::vector<double> stretch = {};  // (triangles) or none, the largest that the given shape has in the wall's plane
};

/// Two parts of the wall within range of each other.
struct FoldContact {
  Eigen::Vector4i vertices;
  FoldPair pair;
};

/// A vertex within range of a floor.
struct FloorContact {
  int vertex = 0;
  Eigen::Vector3d normal;
  DistanceTerms terms;
};

/// What a wall does to itself at a position.
struct SelfContactTerms {
  double energy = 0;         // joule
  double largest_force = 0;  // newton, component at one corner of one pair
  std::vector<FoldContact> folds;
  std::vector<FloorContact> floors;
};

/// Keeps a wall from passing through itself and through the floors.
///
/// Mid-surfaces feel each other at distances below the range, which is for each pair of parts the smallest of the
/// wall's thickness there, 0.4 of the mean edge length of the mesh, and half of the distance that the two have in the
/// stress-free shape, which is the given one shrunk by its prestretch: neighbours do not feel each other unless the
/// wall crumples, nor does a fine mesh, nor does a stretched wall that is let go. Parts that touch in the stress-free
/// shape are left alone, and so are those beside a cut that were neighbours before it: pressed together, the lips of a
/// wound slide over each other by an edge rather than jam in the wall's plane. Parts that a cut leaves all but in each
/// other are left alone too, until the next cut. The force grows without bound as the distance goes to zero, and
/// `safe_fraction` keeps every motion from jumping over it, so that a wall that is free of intersections stays so. The
/// mean edge is that of the wall as it was whole: a cut changes no range elsewhere.
///
/// Pairs whose triangles share no vertex are listed with the margins of their vertices, parts of the edges there. Those
/// of a vertex are kept until it (less the mean motion of all) has moved by its margin from where it was then, and are
/// listed anew for where the others were: so what a few flaps do costs nothing elsewhere. For pairs that share a vertex
/// see StarPairs. After a cut what is known of parts that it has not changed is kept. A wall with nothing near pays a
/// look at each vertex and edge only. Results do not depend on the lists: pairs out of range contribute nothing, and
/// the others come in an order that the mesh alone determines.
class SelfContact {
 public:
  explicit SelfContact(const SelfContactDefinition& definition);

  /// After a cut: `before` knows the wall as it was, whose vertices come first, with the same edge length.
  SelfContact(const SelfContactDefinition& definition, const SelfContact& before);

  /// Metres, by which ranges are measured.
  double edge_length() const { return edge_length_; }

  /// Fraction, from 0 to 1, of the motion (3 vertices, metres) that the wall may go from `position` without meeting
  /// itself or a floor.
  double safe_fraction(const Eigen::VectorXd& position, const Eigen::VectorXd& motion);

  /// Finds out what is near at `position`, which `evaluate` needs to know.
  void look(const Eigen::VectorXd& position);

  /// Fills `terms`, reusing its memory, and adds the forces' opposite to `gradient`, (3 vertices), newton. `position`:
  /// where `look` was last.
  void evaluate(const Eigen::VectorXd& position, SelfContactTerms& terms, Eigen::VectorXd& gradient) const;

  /// Pairs of vertices, the lower first, that pairs listed now couple: those in contact and those that may soon be.
  std::vector<std::array<int, 2>> near_couplings() const;

  /// Pairs listed now that have a marked vertex. `marked`: (vertices).
  std::vector<NearPair> near_pairs_of(std::span<const char> marked) const;

  /// Pascal, of the potentials.
  double pressure() const { return pressure_; }

  /// Times that near pairs were listed, of how many vertices the last time, and how many pairs there are.
  long listings() const { return listings_; }
  std::size_t listed_anew() const;
  std::size_t listed() const;

 private:
  /// Part of the stress-free distance of a pair at which it begins to feel each other; at most that of the given one.
  static constexpr double kRestRange = 0.5;

  /// Vertices and edges that a triangle answers for: up to three of each.
  struct Parts {
    std::array<int, 3> corners;
    std::array<std::array<int, 2>, 3> sides;
    int corner_count = 0, side_count = 0;

    void add_vertex(int vertex) { corners[corner_count++] = vertex; }
    void add_edge(const std::array<int, 2>& edge) { sides[side_count++] = edge; }
    std::span<const int> vertices() const { return std::span(corners).first(corner_count); }
    std::span<const std::array<int, 2>> edges() const { return std::span(sides).first(side_count); }
  };

  /// By the numbers of their triangles.
  struct ListedPair {
    int triangle, other;  // the lower first
    NearPair pair;
  };

  SelfContact(const SelfContactDefinition& definition, const SelfContact* before);
  void measure_parts(const SelfContactDefinition& definition);
  void gather_stars(const StarPairs* before);
  std::vector<char> has_changed_since(const SelfContact& before) const;
  void carry_list(const SelfContact& before);
  void measure_heights(const SelfContactDefinition& definition);
  double margin_of(const Eigen::Vector4i& vertices) const;
  Eigen::Vector3d drift_to(const Eigen::VectorXd& position) const;
  bool is_beyond(std::size_t vertex, const Eigen::VectorXd& position, const Eigen::Vector3d& drift) const;
  bool covers(const Eigen::VectorXd& position) const;
  void note_moved(const Eigen::VectorXd& from, const Eigen::VectorXd& to);
  /// Marks in `far_` the vertices that a list made for the middle of the motion does not cover, and counts them.
  std::size_t mark_far(const Eigen::VectorXd& motion);
  /// So that the list covers both; they must be near enough to each other for a list made for their middle.
  void list_near(const Eigen::VectorXd& from, const Eigen::VectorXd& to);
  template <typename Visit>
  void visit_parts(int triangle, int other, const Visit& visit) const;
  bool were_neighbours(PairKind kind, const Eigen::Vector4i& vertices) const;
  bool is_in_each_other(PairKind kind, const Eigen::Vector4i& vertices, double rest_distance) const;
  bool is_left_alone(PairKind kind, const Eigen::Vector4i& vertices, double rest_distance) const;
  /// Nothing of parts that are left alone.
  std::optional<NearPair> describe(PairKind kind, const Eigen::Vector4i& vertices);
  /// Metres, in the stress-free shape.
  double rest_distance_of(PairKind kind, const Eigen::Vector4i& vertices) const;
  /// Metres, in the given shape: no less than the distance of the two.
  double least_corner_distance(PairKind kind, const Eigen::Vector4i& vertices) const;
  /// `Add`: called with the pair where it is near at the listed position.
  template <typename Add>
  void visit_if_near(PairKind kind, const Eigen::Vector4i& vertices, const Add& add);
  template <typename Visit>
  void visit_near(const Visit& visit) const;
  void add_folds(const Eigen::VectorXd& position, SelfContactTerms& terms, Eigen::VectorXd& gradient) const;
  void add_floors(const Eigen::VectorXd& position, SelfContactTerms& terms, Eigen::VectorXd& gradient) const;
  double safe_fraction_above_floors(const Eigen::VectorXd& position, const Eigen::VectorXd& motion) const;

  std::vector<Eigen::Vector3i> triangles_;
  Eigen::VectorXd rest_position_;         // (3 vertices), metres
  Eigen::VectorXd placement_;             // (3 vertices) or none, metres, as the wall was after a cut
  std::vector<char> held_;                // (vertices), whether no unknown of it moves
  std::vector<Parts> parts_;              // (triangles)
  std::vector<std::vector<int>> across_;  // (vertices), on the other lip of a cut: joined to it before, ascending
  std::vector<double> vertex_area_;       // (vertices), metres^2
  std::vector<double> vertex_thickness_;  // (vertices), metres
  std::vector<double> vertex_shrink_;     // (vertices), at most 1: stress-free lengths there over given ones
  std::vector<FloorPlane> floors_;
  std::vector<std::vector<double>>
      heights_;  // (floors x vertices), metres, stress-free; zero where the floor is not felt
  double pressure_ = 1;
  double largest_range_ = 0;     // metres
  double edge_length_ = 0;       // metres
  std::vector<double> margins_;  // (vertices), metres
  TriangleTree tree_;
  StarPairs stars_;
  std::vector<std::vector<ListedPair>> found_;  // (tasks), by the listing under way; kept for their memory
  std::vector<ListedPair> near_;                // of triangles without a vertex in common, in order of both
  Eigen::VectorXd listed_position_;             // (3 vertices), metres, for which `near_` holds all pairs
  std::vector<char> moved_;                     // (vertices), whether the last listing was for them
  std::vector<char> far_;                       // (vertices), of the motion that is looked along
  std::vector<char> is_new_;                    // (vertices), whether nothing is known of pairs around them
  std::vector<char> left_alone_;                // (vertices), whether parts with them are left alone until the next cut
  long listings_ = 0;
};

template <typename Visit>
void SelfContact::visit_parts(int triangle, int other, const Visit& visit) const {
  const auto apart = [](const Eigen::Vector4i& v) {
    return v[0] != v[1] && v[0] != v[2] && v[0] != v[3] && v[1] != v[2] && v[1] != v[3];
  };
  const auto visit_if_free = [&](PairKind kind, const Eigen::Vector4i& vertices) {
    const bool held = held_[vertices[0]] && held_[vertices[1]] && held_[vertices[2]] && held_[vertices[3]];
    if (!held && apart(vertices)) visit(kind, vertices);
  };
  for (const auto& [one, two] : {std::array{triangle, other}, std::array{other, triangle}}) {
    const Eigen::Vector3i& corners = triangles_[two];
    for (const int vertex : parts_[one].vertices()) {
      visit_if_free(PairKind::kPointTriangle, {vertex, corners[0], corners[1], corners[2]});
    }
  }
  for (const auto& first : parts_[triangle].edges()) {
    for (const auto& second : parts_[other].edges()) {
      visit_if_free(PairKind::kEdgeEdge, {first[0], first[1], second[0], second[1]});
    }
  }
}

template <typename Visit>
void SelfContact::visit_near(const Visit& visit) const {
  stars_.visit_near(visit);
  for (const ListedPair& listed : near_) visit(listed.pair);
}

}  // namespace thinwall
