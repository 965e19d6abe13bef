// A blade in the wall of a body: how hard it pushes, and who pays for what it cuts.

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/cutting/BorderCrossing.hpp"
#include "engine/cutting/SurfaceNormals.hpp"
#include "engine/simulation/Body.hpp"
#include "engine/simulation/FrictionContact.hpp"

namespace thinwall {
namespace {

/// Radius around the tip over which a blade's push is spread: at least so many mean edge lengths, at most this part of
/// the root of the wall's area.
constexpr double kLeastSpread = 1.5;
constexpr double kMostSpread = 0.25;

/// Solutions of a step in which the blade's push is sought, parts of its way by which a wall that sticks to it may miss
/// it meanwhile and after the last one, and part of the cost of a cut that is first taken to drag the wall by the
/// length of a triangle.
constexpr int kPushTurns = 12;
constexpr double kDragTolerance = 0.02;
constexpr double kLooseDragTolerance = 0.2;
constexpr double kFirstPush = 0.25;

/// A wall that bears less of a push than this part bears none.
constexpr double kLeastBearing = 0.05;

/// Mean edge lengths over which the energy that lips release is told to the blade.
constexpr double kSettledEdges = 2;

/// Cost of a cut per length at a place of the wall, newton: the mean of the triangles that have it.
double cost_at(const BodyModel& model, const SurfacePoint& place) {
  Eigen::Index corner = 0;
  if (place.weights.maxCoeff(&corner) < 1) return model.cut_cost(place.triangle);
  const int vertex = model.surface[place.triangle][corner];
  double sum = 0, count = 0;
  for (int t = 0; t < model.triangles(); ++t) {
    if ((model.surface[t].array() != vertex).all()) continue;
    sum += model.cut_cost(t);
    count += 1;
  }
  return sum / count;
}

/// Tension of a triangle along a direction of space, newton / metre; none where it would be pressed.
double tension_along(const MembraneRest& rest, const Material& material, const std::array<Eigen::Vector3d, 3>& corners,
                     const Eigen::Vector3d& direction) {
  Eigen::Matrix<double, 3, 2> edges;
  edges << corners[1] - corners[0], corners[2] - corners[0];
  const Eigen::Matrix<double, 3, 2> gradient = edges * rest.inverse_edges;
  const Eigen::Matrix2d metric = gradient.transpose() * gradient;
  const Eigen::Vector3d stress =
      material.law->respond(material.parameters, {metric(0, 0), metric(1, 1), metric(0, 1)}).second_piola_kirchhoff;
  const Eigen::Vector2d along = gradient.transpose() * direction;
  const double pulled =
      along[0] * along[0] * stress[0] + along[1] * along[1] * stress[1] + 2 * along[0] * along[1] * stress[2];
  return rest.thickness * std::max(0.0, pulled) / std::sqrt(metric.determinant());
}

/// Part of a blade's cost of cutting that a wall bears, spread over a radius around a place: no more than the tension
/// that its push takes away before the place and adds behind it, over the breadth of the spread. A wall that is slack
/// there, as beside a free lip, would crumple instead.
double bearing_at(const BodyModel& model, const Eigen::VectorXd& position, const Eigen::Vector3d& center, double radius,
                  const Eigen::Vector3d& heading, double cost) {
  if (heading.isZero(0)) return 1;
  double tension = 0, area = 0;
  for (int t = 0; t < model.triangles(); ++t) {
    const auto at_rest = corners_of(model.surface[t], model.rest_position);
    if (((at_rest[0] + at_rest[1] + at_rest[2]) / 3 - center).norm() > radius) continue;
    const auto corners = corners_of(model.surface[t], position);
    tension += model.rest[t].area * tension_along(model.rest[t], model.material(t), corners, heading.normalized());
    area += model.rest[t].area;
  }
  return area > 0 ? std::min(1.0, 4 * radius * tension / (area * cost)) : 0;
}

}  // namespace

void Body::push_with(double push, const std::optional<BladeInput>& blade, EquilibriumProblem& problem) const {
  problem.push = blade ? std::min(push, state_.cut.resistance) : 0;
  problem.cut_force = force_at_lips(let_go(state_.cut, blade, problem.push), model_->unknowns());
}

double Body::drag_of(const BladeInput& blade, const Eigen::VectorXd& motion) const {
  const CutProgress& cut = state_.cut;
  if (cut.tip) return blade.direction.dot(motion.segment<3>(3 * *cut.tip));
  return cut.start ? blade.direction.dot(place_on(*model_, cut.start->triangle, cut.start->weights, motion)) : 0;
}

Body::PushVerdict Body::revise_push(const std::optional<BladeInput>& blade, const Eigen::VectorXd& position,
                                    PushSearch& search, EquilibriumProblem& problem) const {
  if (!blade || blade->travel <= 0 || state_.cut.pushed.empty()) return PushVerdict::kFound;
  const double drag = drag_of(*blade, position - state_.equilibrium.position);
  const double push = problem.push, resistance = state_.cut.resistance;
  const double miss = blade->travel - drag;  // metres by which the wall stays behind the edge
  if (push == resistance && miss >= 0) return PushVerdict::kFound;
  const double tolerance = search.turns < kPushTurns ? kDragTolerance : kLooseDragTolerance;
  if (std::abs(miss) <= tolerance * blade->travel) return PushVerdict::kFound;
  if (search.turns == kPushTurns) return PushVerdict::kNone;
  if (search.turns > 0 && push != search.push) {
    search.compliance = std::max(0.0, (drag - search.drag) / (push - search.push));
  }
  ++search.turns;
  search.push = push;
  search.drag = drag;
  const double compliance =
      search.compliance > 0 ? search.compliance : model_->edge_length / (kFirstPush * state_.cut.cost);
  const double wanted = std::clamp(push + miss / compliance, 0.0, resistance);
  // A blade that need not push at all is outrun by the wall.
  if (wanted == push) return PushVerdict::kFound;
  push_with(wanted, blade, problem);
  return PushVerdict::kRevised;
}

double Body::book_cut(const CutProgress& before, const Eigen::VectorXd& motion, const std::optional<BladeInput>& blade,
                      double push) {
  CutProgress after = let_go(before, blade, push);
  double released = 0, lost = 0;  // joule, by the wall
  for (const CutProgress* progress : {&before, &std::as_const(after)}) {
    for (const HeldLips& lips : progress->held) {
      double& share = lips.pays ? released : lost;
      for (const HeldForce& one : lips.forces) {
        share -= 0.5 * lips.held * one.force.dot(motion.segment<3>(3 * one.vertex));
      }
      for (const HeldTurn& one : lips.turns) share -= 0.5 * lips.held * one.force * motion[one.unknown];
    }
  }
  const double pushed = 0.5 * (before.blade_force + after.blade_force).dot(mean_pushed(after, motion));
  double paid = 0;  // joule, by the blade
  if (blade && blade->travel > 0) {
    const double advance = push >= before.resistance ? std::max(0.0, blade->travel - drag_of(*blade, motion)) : 0;
    paid = 0.5 * (before.push + push) * advance;
    after.progress = advance / blade->travel;
    after.owed += after.cost * advance - paid - released;
    // Lips open by fits and starts, so what they release is smoothed and settled over the lengths of some triangles.
    const double length = kSettledEdges * model_->edge_length, share = std::min(1.0, advance / length);
    if (advance > 0) after.given += share * (released / advance - after.given);
    after.resistance = std::max(0.0, after.cost - after.given + after.owed / length);
    state_.contacts[blade->tool].force -= after.blade_force;
    state_.contacts[blade->tool].touching = true;
  } else {
    after.owed -= released;
  }
  // What the wall releases beyond the cost lightens the blade's work ahead; where there is none left it is lost.
  const double surplus = blade && after.resistance > 0 ? 0 : std::max(0.0, -after.owed);
  after.owed += surplus;
  EnergyBooks& books = state_.books;
  books.fracture += paid + released - surplus;
  after.due -= paid + released - surplus;
  books.jump += surplus + lost;
  books.tool_work += paid + pushed;
  state_.cut = after;
  return pushed - released - lost;
}

void Body::spread_push() {
  CutProgress& progress = state_.cut;
  progress.pushed.clear();
  if (!progress.tip && !progress.start) return;
  const BodyModel& model = *model_;
  double tension = 0, cost = 0;  // newton metre
  for (int t = 0; t < model.triangles(); ++t) {
    const auto corners = corners_of(model.surface[t], state_.equilibrium.position);
    tension += model.rest[t].area * std::max(0.0, largest_tension(model.rest[t], model.material(t), corners));
    cost += model.rest[t].area * model.cut_cost(t);
  }
  const double least = kLeastSpread * model.edge_length, most = kMostSpread * std::sqrt(model.rest_area);
  const double radius = std::clamp(tension > 0 ? 0.5 * cost / tension : most, least, std::max(least, most));
  const std::vector<Eigen::Vector3d> normals = vertex_normals(surface());
  const SurfacePoint tip = progress.tip ? point_at(model.definition.mesh.triangles, *progress.tip) : *progress.start;
  progress.cost = cost_at(model, tip);
  const Eigen::Vector3d center = place_on(model, tip.triangle, tip.weights, model.rest_position);
  const Eigen::Vector3d outwards = smooth_normal(surface(), normals, tip);
  double sum = 0;
  for (int v = 0; v < model.vertices(); ++v) {
    const double part = (model.rest_position.segment<3>(3 * v) - center).norm() / radius;
    if (part >= 1 || normals[v].dot(outwards) <= 0) continue;
    progress.pushed.push_back({.vertex = v, .share = (1 - part * part) * (1 - part * part)});
    sum += progress.pushed.back().share;
  }
  const Eigen::Vector3d ahead = progress.tip ? way_ahead(surface(), *progress.tip) : Eigen::Vector3d::Zero();
  const double bearing = bearing_at(model, state_.equilibrium.position, center, radius, ahead, progress.cost);
  if (bearing < kLeastBearing) progress.pushed.clear();
  for (PushedVertex& pushed : progress.pushed) pushed.share *= bearing / sum;
}

}  // namespace thinwall
