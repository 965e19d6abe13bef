#include "engine/simulation/CutTransfer.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <set>
#include <utility>

#include "engine/cutting/Gapes.hpp"
#include "engine/equilibrium/HeldWall.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "engine/shell/BendingPatches.hpp"
#include "engine/simulation/PartedContents.hpp"

namespace thinwall {
namespace {

/// A field with a value for each triangle; one that is absent or even stays as it is.
template <typename Value>
void carry_field(const std::vector<Value>& before, const Cut& cut, std::vector<Value>& field) {
  if (before.size() <= 1) return;
  for (const TriangleSource& source : cut.triangles) field[source.triangle] = before[main_source(source)];
}

template <typename Value>
void resize_field(std::size_t triangles, std::vector<Value>& field) {
  if (field.size() > 1) field.resize(triangles);
}

Eigen::Vector3d value_at(const SurfacePoint& point, const std::vector<Eigen::Vector3i>& triangles,
                         const Eigen::VectorXd& values) {
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) value += point.weights[k] * values.segment<3>(3 * triangles[point.triangle][k]);
  return value;
}

/// Weights of a place on an edge before that are rounding.
constexpr double kOnEdge = 1e-9;

/// A side of a triangle.
struct TriangleSide {
  int triangle = -1, side = -1;
};

int side_of(const BodyModel& model, int triangle, int edge) {
  const std::array<int, 3>& edges = model.bending[triangle].edges;
  return static_cast<int>(std::ranges::find(edges, edge) - edges.begin());
}

double angle_at(const BodyModel& model, const TriangleSide& side, const Eigen::VectorXd& position) {
  const BendingRest& rest = model.bending[side.triangle];
  return side_angles(rest, patch_of(rest, position, model.vertices()))[side.side] - rest.sides[side.side].rest_angle;
}

/// The turns of a shell's edges go over to what lies on the edges, such that the wall there bends as before: a lip by
/// as much as the whole edge did. New edges within triangles begin with none.
class TurnMap {
 public:
  TurnMap(const BodyModel& before, const BodyModel& after, const Cut& cut) : before_(before), after_(after) {
    if (before.bending.empty()) return;
    for (const VertexSource& source : cut.vertices) places_[source.vertex] = &source.before;
    for (const TriangleSource& source : cut.triangles) triangles_[source.triangle] = &source;
    const MeshEdges old_edges = edges_of(before.vertices(), before.definition.mesh.triangles);
    const MeshEdges new_edges = edges_of(after.vertices(), after.definition.mesh.triangles);
    sources_.resize(new_edges.edges.size());
    for (std::size_t e = 0; e < new_edges.edges.size(); ++e) {
      const std::set<int> supports = supports_of(new_edges.edges[e]);
      if (supports.size() != 2) continue;
      const std::array<int, 2> ends = {*supports.begin(), *supports.rbegin()};
      const auto found = std::ranges::lower_bound(old_edges.edges, ends);
      if (found == old_edges.edges.end() || *found != ends) continue;
      const int old_edge = static_cast<int>(found - old_edges.edges.begin()), edge = static_cast<int>(e);
      const int triangle = triangles_at(new_edges, edge).front();
      for (const int old : triangles_at(old_edges, old_edge)) {
        if (!lies_in(triangle, old)) continue;
        sources_[e] = {.edge = old_edge,
                       .now = {triangle, side_of(after, triangle, edge)},
                       .then = {old, side_of(before, old, old_edge)}};
      }
    }
  }

  /// Of positions; those of the vertices have gone over already.
  void carry(const Eigen::VectorXd& from, Eigen::VectorXd& to) const {
    for (std::size_t e = 0; e < sources_.size(); ++e) {
      const Source& source = sources_[e];
      if (source.edge < 0) continue;
      const double share = after_.bending[source.now.triangle].sides[source.now.side].turn_share;
      if (share == 0) continue;
      const double change = angle_at(before_, source.then, from) - angle_at(after_, source.now, to);
      to[3 * after_.vertices() + static_cast<int>(e)] = change / share;
    }
  }

  /// Of velocities and accelerations, taken to be those of the edges alone.
  void carry_rates(const Eigen::VectorXd& from, Eigen::VectorXd& to) const {
    for (std::size_t e = 0; e < sources_.size(); ++e) {
      const Source& source = sources_[e];
      if (source.edge < 0 || scale(source) == 0) continue;
      to[3 * after_.vertices() + static_cast<int>(e)] = from[3 * before_.vertices() + source.edge] / scale(source);
    }
  }

  /// Lips that are not free yet go on holding what lies on the edges that they held, in even parts.
  void carry(std::vector<HeldLips>& held) const {
    std::vector<std::vector<int>> destinations(static_cast<std::size_t>(before_.unknowns()));
    for (std::size_t e = 0; e < sources_.size(); ++e) {
      if (sources_[e].edge < 0) continue;
      destinations[3 * before_.vertices() + sources_[e].edge].push_back(static_cast<int>(e));
    }
    for (HeldLips& lips : held) {
      std::vector<HeldTurn> turns;
      for (const HeldTurn& turn : lips.turns) {
        const std::vector<int>& parts = destinations[turn.unknown];
        for (const int part : parts) {
          const double force = turn.force * scale(sources_[part]) / static_cast<double>(parts.size());
          if (force != 0) turns.push_back({.unknown = 3 * after_.vertices() + part, .force = force});
        }
      }
      lips.turns = std::move(turns);
    }
  }

 private:
  /// Where the turn of an edge comes from.
  struct Source {
    int edge = -1;  // before; -1: none
    TriangleSide now, then;
  };

  const BodyModel& before_;
  const BodyModel& after_;
  std::map<int, const SurfacePoint*> places_;
  std::map<int, const TriangleSource*> triangles_;
  std::vector<Source> sources_;  // (edges after)

  /// The vertices before among which an edge after lies.
  std::set<int> supports_of(const std::array<int, 2>& ends) const {
    std::set<int> supports;
    for (const int end : ends) {
      const auto found = places_.find(end);
      if (found == places_.end()) {
        supports.insert(end);
        continue;
      }
      const SurfacePoint& place = *found->second;
      for (int k = 0; k < 3; ++k) {
        if (place.weights[k] > kOnEdge) supports.insert(before_.definition.mesh.triangles[place.triangle][k]);
      }
    }
    return supports;
  }

  bool lies_in(int triangle, int old) const {
    const auto found = triangles_.find(triangle);
    if (found == triangles_.end()) return triangle == old;
    return std::ranges::any_of(found->second->before,
                               [&](const TriangleShare& share) { return share.triangle == old; });
  }

  /// Turn of an edge before for that of one after.
  double scale(const Source& source) const {
    const double then = before_.bending[source.then.triangle].sides[source.then.side].turn_share;
    return then == 0 ? 0 : after_.bending[source.now.triangle].sides[source.now.side].turn_share / then;
  }
};

Eigen::VectorXd carried_vertices(const BodyModel& before, const BodyModel& after, const Cut& cut,
                                 const Eigen::VectorXd& values) {
  Eigen::VectorXd carried = Eigen::VectorXd::Zero(after.unknowns());
  const int kept = 3 * before.vertices();
  carried.head(kept) = values.head(kept);
  for (const VertexSource& source : cut.vertices) {
    carried.segment<3>(3 * source.vertex) = value_at(source.before, before.definition.mesh.triangles, values);
  }
  return carried;
}

Eigen::Matrix<double, 3, 2> rest_edges_of(const BodyModel& model, int triangle) {
  const auto corners = corners_of(model.surface[triangle], model.rest_position);
  Eigen::Matrix<double, 3, 2> edges;
  edges << corners[1] - corners[0], corners[2] - corners[0];
  return edges;
}

/// From the axes of a triangle before to those of one in its place: a rotation, as both lie in one plane.
Eigen::Matrix2d turn_between(const BodyModel& before, int from, const BodyModel& after, int to) {
  const Eigen::Matrix<double, 3, 2> old_edges = rest_edges_of(before, from);
  const Eigen::Matrix2d parts =
      (old_edges.transpose() * old_edges).inverse() * old_edges.transpose() * rest_edges_of(after, to);
  const Eigen::Matrix2d in_old_axes = before.rest[from].inverse_edges.inverse() * parts;
  const Eigen::Matrix2d map = after.rest[to].inverse_edges.inverse() * in_old_axes.inverse();
  const Eigen::Vector2d axis = Eigen::Vector2d(map(0, 0) + map(1, 1), map(1, 0) - map(0, 1)).normalized();
  Eigen::Matrix2d turn;
  turn << axis.x(), -axis.y(), axis.y(), axis.x();
  return turn;
}

/// A symmetric tensor (11, 22, `shear` 12) in turned axes.
Eigen::Vector3d turned(const Eigen::Matrix2d& turn, const Eigen::Vector3d& tensor, double shear) {
  Eigen::Matrix2d matrix;
  matrix << tensor[0], tensor[2] / shear, tensor[2] / shear, tensor[1];
  const Eigen::Matrix2d result = turn * matrix * turn.transpose();
  return {result(0, 0), result(1, 1), shear * result(0, 1)};
}

/// Carries tensors of the triangles over by shares of the rest area.
class TensorTransfer {
 public:
  TensorTransfer(const BodyModel& before, const BodyModel& after, const Cut& cut) : after_(after) {
    for (const TriangleSource& source : cut.triangles) {
      for (const TriangleShare& share : source.before) {
        parts_.push_back({source.triangle, share, turn_between(before, share.triangle, after, source.triangle)});
      }
    }
  }

  void carry(std::vector<Eigen::Vector3d>& field, double shear) const {
    if (field.empty()) return;
    const std::vector<Eigen::Vector3d> before = field;
    field.resize(after_.triangles());
    for (const Part& part : parts_) field[part.triangle].setZero();
    for (const Part& part : parts_) {
      field[part.triangle] += part.share.share * turned(part.turn, before[part.share.triangle], shear);
    }
  }

 private:
  struct Part {
    int triangle;
    TriangleShare share;
    Eigen::Matrix2d turn;
  };
  const BodyModel& after_;
  std::vector<Part> parts_;
};

void carry_history(const TensorTransfer& transfer, WallHistory& wall) {
  for (std::vector<Eigen::Vector3d>& branch : wall.branch_stress) transfer.carry(branch, 1);
  for (std::vector<Eigen::Vector3d>& branch : wall.branch_moment) transfer.carry(branch, 1);
  transfer.carry(wall.overstress, 1);
  transfer.carry(wall.overmoment, 1);
  transfer.carry(wall.previous_strain, 2);
  transfer.carry(wall.previous_bending_strain, 2);
}

/// The vertices of a site, ascending after those that it has not: what it is known by after a cut.
std::array<int, 3> marks_of(const BodyModel& model, const ContactSite& site) {
  const Eigen::Vector3i& corners = model.surface[site.triangle];
  std::array<int, 3> vertices = {-1, -1, corners[site.corner]};
  if (site.part != SitePart::kCorner) vertices[1] = corners[(site.corner + 1) % 3];
  if (site.part == SitePart::kFace) vertices[0] = corners[(site.corner + 2) % 3];
  std::ranges::sort(vertices);
  return vertices;
}

/// For each site the one after the cut; -1 where the cut has left none.
std::vector<int> sites_after(const BodyModel& before, const BodyModel& after) {
  std::vector<std::pair<std::array<int, 3>, int>> known;
  known.reserve(after.sites.size());
  for (const ContactSite& site : after.sites) {
    known.emplace_back(marks_of(after, site), static_cast<int>(known.size()));
  }
  std::ranges::sort(known);
  std::vector<int> destination;
  destination.reserve(before.sites.size());
  for (const ContactSite& site : before.sites) {
    const std::array<int, 3> vertices = marks_of(before, site);
    const auto found = std::ranges::lower_bound(known, vertices, {}, &std::pair<std::array<int, 3>, int>::first);
    destination.push_back(found != known.end() && found->first == vertices ? found->second : -1);
  }
  return destination;
}

/// The place on the triangle of a site that has all the vertices of the place.
Eigen::Vector3d weights_on(const Eigen::Vector3i& triangle, const Eigen::Vector3i& before,
                           const Eigen::Vector3d& weights) {
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    for (int old = 0; old < 3; ++old) {
      if (triangle[k] == before[old]) moved[k] = weights[old];
    }
  }
  return moved;
}

void carry_contacts(const BodyModel& before, const BodyState& state, const BodyModel& after, BodyState& carried) {
  const std::vector<int> destination = sites_after(before, after);
  for (std::size_t solid = 0; solid < state.solid_forces.size(); ++solid) {
    carried.solid_forces[solid].assign(after.sites.size(), 0);
    for (std::size_t s = 0; s < destination.size(); ++s) {
      if (destination[s] >= 0) carried.solid_forces[solid][destination[s]] = state.solid_forces[solid][s];
    }
    carried.friction[solid].clear();
    for (const FrictionMemory& memory : state.friction[solid]) {
      const int site = destination[memory.site];
      if (site < 0) continue;
      FrictionMemory moved = memory;
      moved.site = site;
      moved.triangle = after.sites[site].triangle;
      moved.weights = weights_on(after.surface[moved.triangle], before.surface[memory.triangle], memory.weights);
      carried.friction[solid].push_back(moved);
    }
    std::ranges::sort(carried.friction[solid], {}, &FrictionMemory::site);
  }
}

}  // namespace

int main_source(const TriangleSource& source) {
  return std::ranges::max_element(source.before, {}, &TriangleShare::share)->triangle;
}

BodyDefinition cut_definition(const BodyModel& model, const CutSurface& surface, const Cut& cut) {
  const BodyDefinition& before = model.definition;
  const SurfaceMesh& mesh = surface.mesh();
  BodyDefinition after = before;
  after.mesh = mesh;
  if (model.has_fluid()) {
    PartedContents contents = parted_contents(model, mesh, cut);
    after.openings = std::move(contents.openings);
    after.fluid.chambers = std::move(contents.chambers);
    after.fluid.other_chambers = false;
  } else {
    after.openings.clear();
    for (std::vector<int>& gape : gapes_of(surface)) after.openings.push_back({.lips = std::move(gape)});
  }
  after.tension_field = before.tension_field || (before.model == WallModel::kMembrane && !is_held_in_its_plane(model));
  const std::size_t triangles = mesh.triangles.size();
  after.thickness.resize(triangles);
  resize_field(triangles, after.materials);
  resize_field(triangles, after.fibres);
  resize_field(triangles, after.prestretch);
  resize_field(triangles, after.toughness);
  for (const TriangleSource& source : cut.triangles) {
    assert(!source.before.empty());
    double thickness = 0;
    for (const TriangleShare& share : source.before) thickness += share.share * before.thickness[share.triangle];
    after.thickness[source.triangle] = thickness;
  }
  carry_field(before.materials, cut, after.materials);
  carry_field(before.fibres, cut, after.fibres);
  carry_field(before.prestretch, cut, after.prestretch);
  carry_field(before.toughness, cut, after.toughness);
  return after;
}

BodyState carried_over(const BodyModel& before, const BodyState& state, const BodyModel& after, const Cut& cut,
                       const Eigen::Vector3d& gravity) {
  BodyState carried = state;
  const TurnMap turns(before, after, cut);
  for (Eigen::VectorXd BodyState::*values :
       {&BodyState::velocity, &BodyState::acceleration, &BodyState::previous_velocity}) {
    carried.*values = carried_vertices(before, after, cut, state.*values);
    turns.carry_rates(state.*values, carried.*values);
  }
  carried.previous_position = carried_vertices(before, after, cut, state.previous_position);
  carried.equilibrium.position = carried_vertices(before, after, cut, state.equilibrium.position);
  turns.carry(state.previous_position, carried.previous_position);
  turns.carry(state.equilibrium.position, carried.equilibrium.position);
  carried.static_force = carried.load_force = Eigen::VectorXd::Zero(after.unknowns());
  carry_history(TensorTransfer(before, after, cut), carried.wall);
  turns.carry(carried.cut.held);
  carry_contacts(before, state, after, carried);
  carry_contents(before, state, after, cut, gravity, carried);
  std::erase_if(carried.attachments, [&](const Attachment& attachment) {
    return std::ranges::none_of(after.surface, [&](const Eigen::Vector3i& triangle) {
      return std::ranges::all_of(attachment.vertices, [&](int vertex) { return (triangle.array() == vertex).any(); });
    });
  });
  return carried;
}

}  // namespace thinwall
