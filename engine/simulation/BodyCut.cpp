#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "engine/contact/SolidGap.hpp"
#include "engine/cutting/BorderCrossing.hpp"
#include "engine/cutting/SurfaceTrace.hpp"
#include "engine/equilibrium/FrictionContact.hpp"
#include "engine/equilibrium/RigidMotions.hpp"
#include "engine/simulation/Body.hpp"
#include "engine/simulation/CutTransfer.hpp"
#include "engine/simulation/Leakage.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "engine/simulation/ToolFriction.hpp"
#include "engine/solver/InnerProducts.hpp"
#include "engine/tool/ToolSolids.hpp"

namespace thinwall {
namespace {

/// Mean edges by which a cut waits for the blade to come farther, where what it would leave is beyond the wall's law or
/// lies in a tool.
constexpr double kMostAwaited = 3;

/// Mean edges over which a blade that has gone in pays before there is wall in its way: where that does not come it
/// gives way to the blade.
constexpr double kDentedEdges = 0.25;

/// Mean edges from a tool within which triangles stay as they are: another edge between their corners may lie in it.
constexpr double kKeptReach = 0.25;

/// A path shorter than the triangles is cut into smaller ones of this part of it, where it is at least so many mean
/// edges long.
constexpr double kPartOfShortPath = 0.5;
constexpr double kShortestPath = 0.1;

/// Contents that do not run out keep their surface, whatever caps span the lips now.
void keep_surfaces(BodyModel& model, const BodyState& state) {
  if (!model.has_open_chambers() || model.definition.fluid.leaks) return;
  const Eigen::VectorXd below_caps = enclosed_volumes(model, state.equilibrium.position);
  for (Eigen::Index c = 0; c < below_caps.size(); ++c) {
    model.chambers[static_cast<std::size_t>(c)].beyond_caps = state.volume[c] - below_caps[c];
  }
}

/// Whether a path neither goes on from a cut nor will go on.
bool is_whole(const CutPath& path) {
  return !path.from && !path.goes_on;
}

/// Edges of triangles that a short path can be cut into, metres; 0 where it is hardly longer than a point.
double edge_for_short_path(const BodyModel& model, const CutPath& path) {
  const SurfaceView rest{.triangles = model.definition.mesh.triangles, .position = model.rest_position};
  const double length = length_of(rest, path.points);
  return length < kShortestPath * model.edge_length ? 0 : kPartOfShortPath * length;
}

/// Groups that stand for the regions where a body is held: no scenario can name them.
std::string group_of_fixed(std::size_t region) {
  return "\nfixed " + std::to_string(region);
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
  auto model = std::make_unique<BodyModel>(*model_);
  model->definition = std::move(definition);
  newton_ = std::make_unique<Newton>(*model, *newton_, state_.equilibrium.position);
  model_ = std::move(model);
}

void Body::crumple(std::span<const ToolPose> poses) {
  auto model = std::make_unique<BodyModel>(*model_);
  model->definition.tension_field = true;
  newton_ = std::make_unique<Newton>(*model, *newton_, state_.equilibrium.position);
  model_ = std::move(model);
  state_.cut.has_crumpled = report_.crumpled = true;
  hold_as_it_is(model_->edge_length, false, poses);
  // What the wall bore along itself it gives up in a few steps.
  state_.cut.held.back().runs = true;
}

Cut Body::cut(const CutPath& path, std::span<const ToolPose> poses) {
  CutOptions options = options_of_blade(poses);
  Uncut before;
  Cut cut = change_mesh(path, options, &before);
  if (cut.triangles.empty() && is_whole(path)) {
    options.edge_length = edge_for_short_path(*model_, path);
    if (options.edge_length > 0) cut = change_mesh(path, options, &before);
  }
  if (cut.triangles.empty()) return cut;
  state_.cut.has_incised = true;
  state_.cut.start.reset();
  state_.cut.tip = cut.tip;
  state_.cut.cost = cut.tip ? cost_at(point_at(model_->definition.mesh.triangles, *cut.tip))
                            : model_->cut_cost(cut.triangles.front().triangle);
  state_.cut.due += state_.cut.cost * cut.length;
  // The blade goes its way over the wall as it is stretched now.
  const double length = length_of(cut.lips, state_.equilibrium.position);
  if (length > 0) state_.cut.cost *= cut.length / length;
  const double bending = state_.books.bending;
  hold_as_it_is(cut.length, true, poses);
  // Around the new triangles a bent shell stores more than before, which is released with the lips: the wall has not
  // given it, so that it pays for no area.
  const double gained = state_.books.bending - bending;  // joule
  state_.books.jump += gained;
  state_.books.fracture -= gained;
  state_.cut.due += gained;
  let_free_parts_go();
  const bool is_awaited_long = cut.length > kMostAwaited * model_->edge_length;
  const double pressed = contact_energy(newton_->terms()) - before.state.books.contact;  // joule
  const bool lies_in_tool = pressed > state_.cut.cost * length;
  if (std::isfinite(state_.books.elastic) && (!lies_in_tool || is_awaited_long)) return cut;
  if (is_awaited_long) {
    throw SimulationFailure("body `" + model_->definition.name +
                            "`: triangles that a cut leaves are stretched beyond what the wall's law allows; give the "
                            "body more triangles, or the law a larger limit");
  }
  put_back(std::move(before));
  return {};
}

CutOptions Body::options_of_blade(std::span<const ToolPose> poses) const {
  CutOptions options;
  if (state_.cut.tool) options.deviation = tools_[*state_.cut.tool].deviation;
  std::vector<ToolSolid> solids;
  for (int tool = 0; tool < static_cast<int>(tools_.size()); ++tool) {
    if (state_.cut.tool == tool) continue;
    std::ranges::copy(contact_solids(tools_[tool], poses[tool]), std::back_inserter(solids));
  }
  if (solids.empty()) return options;
  const double reach = kKeptReach * model_->edge_length;
  for (int t = 0; t < model_->triangles(); ++t) {
    const auto corners = corners_of(model_->surface[t], state_.equilibrium.position);
    const bool is_near = std::ranges::any_of(solids, [&](const ToolSolid& solid) {
      const auto face = solid_gap(solid, reach, corners, SitePart::kFace, 0, GapTerms::kGradient);
      return face && face->gap < reach;
    });
    if (is_near) options.kept_triangles.push_back(t);
  }
  return options;
}

Cut Body::change_mesh(const CutPath& path, CutOptions options, Uncut* before) {
  assert(!model_->definition.toughness.empty());
  if (!surface_) prepare_cutting();
  for (int v = 0; v < model_->vertices(); ++v) {
    const char* fixed = &model_->fixed[3 * v];
    if (fixed[0] || fixed[1] || fixed[2]) options.kept_vertices.push_back(v);
  }
  for (int v = 0; v < model_->vertices(); ++v) {
    options.placement.push_back(state_.equilibrium.position.segment<3>(3 * v));
  }
  if (before != nullptr) before->surface = std::make_unique<CutSurface>(*surface_);
  Cut cut = surface_->cut(path, options);
  // Where none of the triangles beside tools may change there may be no room for a cut: then they do.
  if (cut.triangles.empty() && !options.kept_triangles.empty()) {
    options.kept_triangles.clear();
    cut = surface_->cut(path, options);
  }
  if (cut.triangles.empty()) return cut;
  if (before != nullptr) before->state = state_;
  // Places on triangles that are not there any more: a blade looks for the wall anew.
  const auto is_changed = [&](int triangle) {
    return std::ranges::binary_search(cut.triangles, triangle, {}, &TriangleSource::triangle);
  };
  if (state_.cut.start && is_changed(state_.cut.start->triangle)) state_.cut.start.reset();
  if (state_.cut.gap && is_changed(state_.cut.gap->lip.triangle)) state_.cut.gap.reset();
  auto after =
      std::make_unique<BodyModel>(make_body_model(cut_definition(*model_, *surface_, cut), model_->slack_stiffness));
  state_ = carried_over(*model_, state_, *after, cut, options_.gravity);
  keep_surfaces(*after, state_);
  // A piece that nothing holds any more stays where it has just come off.
  if (after->rigid_motions.cols() > 0) hold_rigid_motions(*after, state_.equilibrium.position);
  // Forces and ways of the step before are those of another mesh.
  state_.drag_force.resize(0);
  last_step_.reset();
  // An opening that has changed makes a new beginning.
  state_.outflow = {};
  auto newton = std::make_unique<Newton>(*after, *newton_, state_.equilibrium.position);
  if (before != nullptr) {
    before->model = std::move(model_);
    before->newton = std::move(newton_);
  }
  newton_ = std::move(newton);
  model_ = std::move(after);
  find_strains(*model_, state_.equilibrium.position, state_.wall);
  measure_openings(*model_, state_);
  state_.cut.length += cut.length;
  return cut;
}

void Body::find_forces(std::span<const ToolPose> poses) {
  EquilibriumProblem problem;
  add_fluids(0, {}, problem);
  Leakage(*model_, state_, options_.gravity, options_.time_step).add_to(problem);
  problem.memory.scale = lasting_part(model_->definition);
  problem.memory.overstress = state_.wall.overstress;
  problem.memory.overmoment = state_.wall.overmoment;
  problem.gravity = options_.gravity;
  problem.load_factors = state_.load_factors;
  problem.start = state_.equilibrium.position;
  problem.cut_force = force_at_lips(state_.cut, model_->unknowns());
  problem.attachments = state_.attachments;
  if (options_.analysis == Analysis::kDynamic) problem.fluid_inertia = fluid_inertia_now(*model_, state_);
  step_contacts().add_solids(poses, problem);
  problem.friction = FrictionSearch(*model_, state_, tools_, poses).first(problem);
  step_contacts().add_shafts(poses, problem);
  newton_->look(problem, state_.equilibrium);
  // What the tools felt during the step stays what it was.
  const std::vector<ToolContact> contacts = state_.contacts, solid_contacts = state_.solid_contacts;
  update_forces(problem);
  state_.contacts = contacts;
  state_.solid_contacts = solid_contacts;
  double on_shafts = 0;
  for (const ShaftContact& shaft : problem.shafts) on_shafts += shaft.stored(state_.equilibrium.position);
  book_stored(on_shafts);
}

void Body::hold_as_it_is(double length, bool pays, std::span<const ToolPose> poses) {
  const double stored = state_.books.stored();
  find_forces(poses);
  // Flips of edges and lumped masses change what is stored by a trifle.
  state_.books.jump += stored - state_.books.stored();
  const double cost = state_.cut.cost > 0 ? state_.cut.cost : model_->cut_cost(0);
  HeldLips held{.forces = {}, .length = length, .worth = cost * length, .pays = pays};
  // What slowed the wall is among them from now on.
  state_.drag_force.resize(0);
  Eigen::VectorXd left_over =
      state_.static_force +
      model_->mass.cwiseProduct(state_.acceleration + model_->definition.damping.mass_rate * state_.velocity);
  // What points and lines hold they go on to hold.
  for (const Attachment& attachment : state_.attachments) {
    for (int k = 0; k < 3; ++k) {
      left_over.segment<3>(3 * attachment.vertices[k]) += attachment.weights[k] * attachment.force;
    }
  }
  for (int v = 0; v < model_->vertices(); ++v) {
    HeldForce one{.vertex = v, .force = left_over.segment<3>(3 * v)};
    for (int axis = 0; axis < 3; ++axis) {
      if (model_->fixed[3 * v + axis]) one.force[axis] = 0;
    }
    if (!one.force.isZero(0)) held.forces.push_back(one);
  }
  for (int k = 3 * model_->vertices(); k < model_->unknowns(); ++k) {
    if (!model_->fixed[k] && left_over[k] != 0) held.turns.push_back({.unknown = k, .force = left_over[k]});
  }
  for (const HeldForce& one : held.forces) {
    state_.load_force.segment<3>(3 * one.vertex) += one.force;
    state_.static_force.segment<3>(3 * one.vertex) -= one.force;
  }
  for (const HeldTurn& one : held.turns) {
    state_.load_force[one.unknown] += one.force;
    state_.static_force[one.unknown] -= one.force;
  }
  state_.cut.held.push_back(std::move(held));
}

void Body::let_free_parts_go() {
  const Eigen::MatrixXd& motions = model_->rigid_motions;
  if (motions.cols() == 0) return;
  const Eigen::VectorXd& mass = model_->mass;
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> inertia(
      inner_products(motions, mass.asDiagonal() * motions));
  Eigen::VectorXd whole = Eigen::VectorXd::Zero(model_->unknowns());  // metres / second^2
  for (HeldLips& lips : state_.cut.held) {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(model_->unknowns());
    for (const HeldForce& one : lips.forces) forces.segment<3>(3 * one.vertex) += one.force;
    const Eigen::VectorXd acceleration = motions * inertia.solve(motions.transpose() * forces);
    if (acceleration.isZero(0)) continue;
    const Eigen::VectorXd lost = mass.cwiseProduct(acceleration);
    forces -= lost;
    lips.forces.clear();
    for (int v = 0; v < model_->vertices(); ++v) {
      const HeldForce one{.vertex = v, .force = forces.segment<3>(3 * v)};
      if (!one.force.isZero(0)) lips.forces.push_back(one);
    }
    state_.load_force -= lips.held * lost;
    state_.static_force += lips.held * lost;
    whole += lips.held * acceleration;
  }
  if (!has_inertia() || whole.isZero(0)) return;
  state_.acceleration -= whole;
  // The steps to come see the one before, in which such a part still hung together with the rest, by its velocity.
  const Eigen::VectorXd change =
      state_.velocity - state_.previous_velocity - state_.previous_step * state_.acceleration;
  const Eigen::VectorXd as_a_whole = motions * inertia.solve(motions.transpose() * mass.cwiseProduct(change));
  for (int v = 0; v < model_->vertices(); ++v) {
    if (whole.segment<3>(3 * v).isZero(0)) continue;
    state_.previous_velocity.segment<3>(3 * v) += as_a_whole.segment<3>(3 * v);
  }
}

std::optional<Cut> Body::follow_blade(int tool, std::span<const ToolPose> poses, bool goes_on) {
  const ToolPose& pose = poses[tool];
  const BladeWay blade = way_of_blade(tool);
  CutProgress& progress = state_.cut;
  if (progress.ahead > 0 || come_out_of_gap(pose)) return std::nullopt;
  if (!progress.is_in_wall()) {
    auto place = blade.place_below(pose);
    if (!place) place = place_before(tool, pose);
    if (place && !progress.gap) {
      progress.tool = tool;
      begin_cut(*place);
      hold_dent(tool, poses);
    }
    return std::nullopt;
  }
  const bool was_in_wound = std::exchange(progress.is_in_wound, blade.is_in_wound(pose));
  const bool leaves_earlier = was_in_wound && !progress.is_in_wound && !progress.tip;
  if (const auto place = leaves_earlier ? blade.place_below(pose) : std::nullopt) {
    begin_cut(*nearest_on_border(surface(), position_of(surface(), *place)));
  }
  const bool was_off_wall = std::exchange(progress.is_off_wall, false);
  if (progress.is_in_wound) return std::nullopt;
  std::optional<WayOn> way = blade.on(pose);
  // Behind its cut's tip it may have been in the air as well as in the wound: no step leads from there so far.
  if (way && was_in_wound && blade.is_far(*way)) way.reset();
  if (!way) way = blade.out_of_wound(pose);
  // It has passed above what lies between where the wall gave way from under it and where it meets it again.
  if (way && was_off_wall && blade.is_far(*way)) way.reset();
  if (!way) {
    // Before its first cut the wall is dented, and what dents it is the blade: but no farther than that.
    const double most = kDentedEdges * model_->edge_length * progress.cost;  // joule
    progress.is_off_wall = progress.tip || progress.due < -most;
    begin_anew_far_off(tool, pose);
    return std::nullopt;
  }
  way = blade.brought_from_border(*std::move(way));
  if (!goes_on && !way->border) way = blade.brought_to_border(*std::move(way));
  way->path.goes_on = goes_on && !way->border;
  return go_on(*way, pose, poses);
}

std::optional<Cut> Body::go_on(const WayOn& way, const ToolPose& pose, std::span<const ToolPose> poses) {
  const double length = length_of(surface(), way.path.points);
  Cut cut = this->cut(way.path, poses);
  const double made = length_of(cut.lips, state_.equilibrium.position);
  // Measured rather than added up of what the blade goes and the wall before it moves: where that springs back, folds
  // or is cut from a vertex on, the sum is not what is cut.
  state_.cut.owed = unpaid(state_.cut) + state_.cut.cost * (length - made);
  if (cut.triangles.empty()) return std::nullopt;
  if (way.border && !cut.tip) find_gap(cut, *way.border, way.sense, pose);
  return cut;
}

void Body::hold_dent(int tool, std::span<const ToolPose> poses) {
  bool is_dented = false;
  for (std::size_t k = 0; k < solids_.size(); ++k) {
    if (solids_[k] != tool) continue;
    is_dented = is_dented || std::ranges::any_of(state_.solid_forces[k], [](double force) { return force > 0; });
    std::ranges::fill(state_.solid_forces[k], 0);
    state_.friction[k].clear();
    // From here on the tool does no work there.
    state_.solid_contacts[k] = {};
  }
  if (!is_dented) return;
  // What held the dent goes over to the first cut, of the blade's width: the energy of the dent pays for it.
  hold_as_it_is(tools_[tool].width, true, poses);
}

void Body::begin_cut(const SurfacePoint& place) {
  state_.cut.start = place;
  state_.cut.cost = state_.cut.resistance = cost_at(place);
}

void Body::leave_cut() {
  // What has been cut has cost what its area is worth: the way of the blade less that of the wall is that but for a
  // part of an edge.
  const double due = std::exchange(state_.cut.due, 0);
  state_.books.fracture += due;
  state_.books.jump -= due;
  state_.cut.gap.reset();
  state_.cut.is_in_wound = state_.cut.is_off_wall = false;
  state_.cut.tool.reset();
  state_.cut.tip.reset();
  state_.cut.start.reset();
  state_.cut.resistance = state_.cut.push = state_.cut.progress = state_.cut.given = state_.cut.owed = 0;
  state_.cut.ahead = state_.cut.awaited = 0;
}

}  // namespace thinwall
