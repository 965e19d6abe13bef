#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/cutting/SurfaceNormals.hpp"
#include "engine/cutting/SurfaceTrace.hpp"
#include "engine/simulation/Body.hpp"
#include "engine/simulation/CutTransfer.hpp"
#include "engine/simulation/FrictionContact.hpp"
#include "engine/simulation/SimulationFailure.hpp"

namespace thinwall {
namespace {

/// Radius around the tip over which a blade's push is spread: at least so many mean edge lengths, at most this part of
/// the root of the wall's area.
constexpr double kLeastSpread = 1.5;
constexpr double kMostSpread = 0.25;

/// Solutions of a step in which the blade's push is sought, part of its way by which a wall that sticks to it may miss
/// it, and part of the cost of a cut that is first taken to drag the wall by the length of a triangle.
constexpr int kPushTurns = 12;
constexpr double kDragTolerance = 0.02;
constexpr double kFirstPush = 0.25;

/// Mean edge lengths over which the energy that lips release is told to the blade.
constexpr double kSettledEdges = 2;

/// Groups that stand for the regions where a body is held: no scenario can name them.
std::string group_of_fixed(std::size_t region) {
  return "\nfixed " + std::to_string(region);
}

double value_of(const std::vector<double>& field, int triangle) {
  return field[field.size() == 1 ? 0 : static_cast<std::size_t>(triangle)];
}

/// What the new area of a cut costs, joule.
double cost_of(const BodyModel& model, const Cut& cut) {
  // Per length, the mean of the triangles around a vertex.
  std::vector<double> costs(model.vertices(), 0), counts(model.vertices(), 0);
  for (int t = 0; t < model.triangles(); ++t) {
    for (const int vertex : model.surface[t]) {
      costs[vertex] += value_of(model.definition.toughness, t) * model.rest[t].thickness;
      counts[vertex] += 1;
    }
  }
  double cost = 0;
  for (const Lips& lips : cut.lips) {
    for (std::size_t k = 0; k + 1 < lips.left.size(); ++k) {
      const int from = lips.left[k], to = lips.left[k + 1];
      const Eigen::Vector3d way = model.rest_position.segment<3>(3 * to) - model.rest_position.segment<3>(3 * from);
      cost += 0.5 * (costs[from] / counts[from] + costs[to] / counts[to]) * way.norm();
    }
  }
  return cost;
}

SurfacePoint point_at(const SurfaceView& surface, int vertex) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (surface.triangles[t][k] == vertex) {
        return {.triangle = static_cast<int>(t), .weights = Eigen::Vector3d::Unit(k)};
      }
    }
  }
  assert(false && "the vertex belongs to no triangle");
  return {};
}

}  // namespace

void Body::prepare_cutting() {
  // Where a body is held is told by vertices from now on: a place that a cut makes between a held vertex and a free one
  // must not be caught by a region.
  BodyDefinition definition = model_->definition;
  for (std::size_t k = 0; k < definition.fixed.size(); ++k) {
    definition.mesh.groups[group_of_fixed(k)] = vertices_in(definition.fixed[k].region, definition.mesh);
    definition.fixed[k].region = GroupRegion{group_of_fixed(k)};
  }
  surface_ = std::make_unique<CutSurface>(definition.mesh);
  model_ = std::make_unique<const BodyModel>(make_body_model(std::move(definition)));
  newton_ = std::make_unique<Newton>(*model_);
}

Cut Body::cut(const CutPath& path, std::span<const ToolPose> poses) {
  assert(!model_->definition.toughness.empty());
  if (!surface_) prepare_cutting();
  CutOptions options;
  for (int v = 0; v < model_->vertices(); ++v) {
    const char* fixed = &model_->fixed[3 * v];
    if (fixed[0] || fixed[1] || fixed[2]) options.kept_vertices.push_back(v);
  }
  const CutSurface uncut = *surface_;
  Cut cut = surface_->cut(path, options);
  if (cut.triangles.empty()) return cut;
  auto after =
      std::make_unique<const BodyModel>(make_body_model(cut_definition(model_->definition, surface_->mesh(), cut)));
  if (after->chambers.size() != model_->chambers.size()) {
    *surface_ = uncut;
    throw SimulationFailure("body `" + model_->definition.name + "`: a cut divides what holds its contents");
  }
  state_ = carried_over(*model_, state_, *after, cut);
  // An opening that has changed makes a new beginning.
  state_.outflow = {};
  model_ = std::move(after);
  newton_ = std::make_unique<Newton>(*model_);
  find_strains();
  measure_openings();
  state_.cut.start.reset();
  state_.cut.tip = cut.tip;
  state_.cut.length += cut.length;
  spread_push();
  const double stored = state_.books.stored();
  find_forces(poses);
  // Flips of edges and lumped masses change what is stored by a trifle.
  state_.books.jump += stored - state_.books.stored();
  hold_lips(cut);
  find_forces(poses);
  return cut;
}

void Body::find_forces(std::span<const ToolPose> poses) {
  EquilibriumProblem problem;
  add_fluids(0, {}, problem);
  add_leaks(options_.time_step, problem);
  problem.memory.scale = lasting_part(model_->definition);
  problem.memory.overstress = state_.wall.overstress;
  problem.memory.overmoment = state_.wall.overmoment;
  problem.gravity = options_.gravity;
  problem.load_factors = state_.load_factors;
  problem.start = state_.equilibrium.position;
  problem.cut_force = force_at_lips(state_.cut, model_->unknowns());
  problem.attachments = state_.attachments;
  add_solids(poses, problem);
  newton_->look(problem, state_.equilibrium);
  // What the tools felt during the step stays what it was.
  const std::vector<ToolContact> contacts = state_.contacts, solid_contacts = state_.solid_contacts;
  update_forces(problem);
  state_.contacts = contacts;
  state_.solid_contacts = solid_contacts;
  const EquilibriumTerms& terms = newton_->terms();
  EnergyBooks& books = state_.books;
  books.elastic = lasting_part(model_->definition) * terms.strain_energy;
  books.bending = lasting_part(model_->definition) * terms.bending_energy;
  books.kinetic = 0.5 * model_->mass.dot(state_.velocity.cwiseAbs2()) + fluid_kinetic_energy();
  books.gravity = gravity_energy();
  books.contact = contact_energy(terms) + terms.folds.energy + state_.friction_energy;
}

void Body::hold_lips(const Cut& cut) {
  HeldLips held{.forces = {}, .length = cut.length, .cost = cost_of(*model_, cut)};
  const Eigen::VectorXd left_over =
      state_.static_force +
      model_->mass.cwiseProduct(state_.acceleration + model_->definition.damping.mass_rate * state_.velocity);
  for (int v = 0; v < model_->vertices(); ++v) {
    HeldForce one{.vertex = v, .force = left_over.segment<3>(3 * v)};
    for (int axis = 0; axis < 3; ++axis) {
      if (model_->fixed[3 * v + axis]) one.force[axis] = 0;
    }
    if (!one.force.isZero(0)) held.forces.push_back(one);
  }
  state_.cut.held.push_back(std::move(held));
}

void Body::push_with(double push, const std::optional<BladeInput>& blade, EquilibriumProblem& problem) const {
  problem.push = blade ? push : 0;
  problem.cut_force = force_at_lips(let_go(state_.cut, blade, push), model_->unknowns());
}

double Body::drag_of(const BladeInput& blade, const Eigen::VectorXd& motion) const {
  const CutProgress& cut = state_.cut;
  if (cut.tip) return blade.direction.dot(motion.segment<3>(3 * *cut.tip));
  return cut.start ? blade.direction.dot(place_on(*model_, cut.start->triangle, cut.start->weights, motion)) : 0;
}

bool Body::revise_push(const std::optional<BladeInput>& blade, const Eigen::VectorXd& position, PushSearch& search,
                       EquilibriumProblem& problem) const {
  if (!blade || blade->travel <= 0 || state_.cut.pushed.empty() || ++search.turns > kPushTurns) return false;
  const double drag = drag_of(*blade, position - state_.equilibrium.position);
  const double push = problem.push, resistance = state_.cut.resistance;
  const double miss = blade->travel - drag;  // metres by which the wall stays behind the edge
  if (push >= resistance && push <= resistance && miss >= 0) return false;
  if (push < resistance && std::abs(miss) <= kDragTolerance * blade->travel) return false;
  if (search.turns > 1 && push != search.push) {
    search.compliance = std::max(0.0, (drag - search.drag) / (push - search.push));
  }
  search.push = push;
  search.drag = drag;
  const double compliance =
      search.compliance > 0 ? search.compliance : model_->edge_length / (kFirstPush * state_.cut.cost);
  const double wanted = std::clamp(push + miss / compliance, 0.0, resistance);
  if (wanted == push) return false;
  push_with(wanted, blade, problem);
  return true;
}

double Body::book_cut(const CutProgress& before, const Eigen::VectorXd& motion, const std::optional<BladeInput>& blade,
                      double push) {
  CutProgress after = let_go(before, blade, push);
  double released = 0;  // joule, by the wall
  for (const CutProgress* progress : {&before, &std::as_const(after)}) {
    for (const HeldLips& lips : progress->held) {
      for (const HeldForce& one : lips.forces) {
        released -= 0.5 * lips.held * one.force.dot(motion.segment<3>(3 * one.vertex));
      }
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
  books.jump += surplus;
  books.tool_work += paid + pushed;
  state_.cut = after;
  return pushed - released;
}

std::optional<Cut> Body::follow_blade(int tool, std::span<const ToolPose> poses) {
  const ToolPose& pose = poses[tool];
  const SurfaceView wall = surface();
  const auto entry = first_entry_on_segment(wall, pose.tip - tools_[tool].length * pose.direction, pose.tip);
  if (!entry) return std::nullopt;
  const SurfacePoint target = snapped_to_edges(wall, {.triangle = entry->triangle, .weights = entry->weights});
  CutProgress& progress = state_.cut;
  if (!progress.tip && !progress.start) {
    progress.tool = tool;
    progress.start = target;
    spread_push();
    progress.resistance = progress.cost;
    for (std::size_t k = 0; k < solids_.size(); ++k) {
      if (solids_[k] == tool) std::ranges::fill(state_.solid_forces[k], 0);
    }
    return std::nullopt;
  }
  const SurfacePoint from = progress.tip ? point_at(wall, *progress.tip) : *progress.start;
  const SurfaceTrace way = trace(wall, vertex_normals(wall), from, target);
  if (way.pieces.empty()) return std::nullopt;
  CutPath path{.from = progress.tip, .points = way.pieces.front().points};
  Cut cut = this->cut(path, poses);
  if (cut.triangles.empty()) return std::nullopt;
  return cut;
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
    cost += model.rest[t].area * value_of(model.definition.toughness, t) * model.rest[t].thickness;
  }
  progress.cost = cost / model.rest_area;
  const double least = kLeastSpread * model.edge_length, most = kMostSpread * std::sqrt(model.rest_area);
  const double radius = std::clamp(tension > 0 ? 0.5 * cost / tension : most, least, std::max(least, most));
  const std::vector<Eigen::Vector3d> normals = vertex_normals(surface());
  const SurfacePoint tip = progress.tip ? point_at(surface(), *progress.tip) : *progress.start;
  const Eigen::Vector3d center = place_on(model, tip.triangle, tip.weights, model.rest_position);
  const Eigen::Vector3d outwards = smooth_normal(surface(), normals, tip);
  double sum = 0;
  for (int v = 0; v < model.vertices(); ++v) {
    const double part = (model.rest_position.segment<3>(3 * v) - center).norm() / radius;
    if (part >= 1 || normals[v].dot(outwards) <= 0) continue;
    progress.pushed.push_back({.vertex = v, .share = (1 - part * part) * (1 - part * part)});
    sum += progress.pushed.back().share;
  }
  for (PushedVertex& pushed : progress.pushed) pushed.share /= sum;
}

void Body::leave_cut() {
  state_.cut.tool.reset();
  state_.cut.tip.reset();
  state_.cut.start.reset();
  state_.cut.pushed.clear();
  state_.cut.resistance = state_.cut.push = state_.cut.progress = state_.cut.given = state_.cut.owed = 0;
  state_.cut.blade_force.setZero();
}

}  // namespace thinwall
