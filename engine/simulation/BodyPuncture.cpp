// A needle that goes through the wall of a body: when the wall gives way, and what it does on the shaft.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/simulation/Body.hpp"
#include "engine/simulation/Leakage.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "engine/tool/ToolSolids.hpp"

namespace thinwall {
namespace {

/// Edges along a slit over the needle's radius: as coarse as will do.
constexpr double kSlitEdges[] = {0.5, 0.25};

/// Part of the needle's width that a slit may be longer or shorter: it costs that much more or less.
constexpr double kSlitGive = 0.02;

/// Parts of a needle's radius in which a slit is spread on the shaft while a wall gives way: at first, and at least
/// where the wall jams.
constexpr double kSpreadStep = 0.25;
constexpr double kLeastSpreadStep = 0.05;

/// A wall gives way in this part of a time step: at once, but for what viscous walls remember.
constexpr double kAtOnce = 1e-9;

/// Work over the cost of a slit at which a needle that cannot be let through for another reason than energy gives up.
constexpr double kMostWork = 3;

/// Part of the cost of a slit that a needle must have worked before it is asked whether a slit pays: a tense wall adds
/// what the slit itself releases.
constexpr double kLeastWork = 0.75;

/// Of the energy that is missing, the work that a needle must do before it is asked for again.
constexpr double kMissingPart = 0.8;

/// The same as a part of the slit's cost, where the wall has found no equilibrium on the shaft.
constexpr double kRetryPart = 0.1;

/// Whether a needle's axis goes through a triangle, its tip being beyond it.
bool is_through(const std::array<Eigen::Vector3d, 3>& corners, const ToolPose& pose) {
  const auto found = where_axis_meets(corners, pose);
  return found && found->ahead < 0;
}

/// Slits around which the wall may find no equilibrium on the shaft before the needle is let go on: where one along the
/// one axis of the needle jams, one along the other may not.
constexpr int kMostJams = 2;

}  // namespace

Body::ShaftBooks Body::book_shafts(const EquilibriumProblem& problem, std::span<const ToolPose> begin) {
  ShaftBooks books;
  auto shaft = problem.shafts.cbegin();
  for (Puncture& puncture : state_.punctures) {
    if (!puncture.is_sealed()) continue;
    const double coefficient = tools_[*puncture.tool].friction;
    for (ShaftPoint& point : puncture.points) {
      const Eigen::Vector3d place = state_.equilibrium.position.segment<3>(3 * point.vertex);
      const ShaftTerms terms = shaft->at(point, place);
      const double slip = shaft->behind_tip(place) - point.anchor;
      const double slid = slip - std::clamp(slip, -shaft->give, shaft->give);
      books.friction += 0.5 * (point.friction + terms.friction) * slid;
      books.stored += terms.stored;
      point.friction = terms.friction;
      point.anchor += slid;
      point.limit = coefficient * std::max(0.0, terms.squeeze);
    }
    const Eigen::Vector3d force = shaft->force(state_.equilibrium.position);
    books.tool_work -= 0.5 * (puncture.force + force).dot(shaft->tip - begin[*puncture.tool].tip);
    puncture.force = force;
    state_.contacts[*puncture.tool].force += force;
    state_.contacts[*puncture.tool].touching = true;
    ++shaft;
  }
  return books;
}

void Body::track_pressing(const BodyState& before, std::span<const ToolPose> begin, const EquilibriumProblem& problem) {
  for (std::size_t tool = 0; tool < tools_.size(); ++tool) {
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), motion = Eigen::Vector3d::Zero();
    bool touches = false;
    const std::vector<ToolSolid> solids = contact_solids(tools_[tool], begin[tool]);
    const std::size_t first = std::ranges::find(solids_, static_cast<int>(tool)) - solids_.begin();
    for (std::size_t k = 0; k < solids.size(); ++k) {
      force += before.solid_contacts[first + k].force + state_.solid_contacts[first + k].force;
      motion = problem.solids[first + k].solid.center - solids[k].center;
      touches = touches || state_.solid_contacts[first + k].touching;
    }
    Pressing& pressing = state_.pressing[tool];
    pressing.recedes = motion.dot(begin[tool].direction) < 0;
    if (touches) pressing.work -= 0.5 * force.dot(motion);
    if (!touches) pressing = {};
  }
}

bool Body::snap(std::span<const ToolPose> poses) {
  const EnergyBooks before = state_.books;
  const BodyInput input{.load_factors = state_.load_factors, .fluids = {}};
  snaps_ = true;
  state_.previous_step = 0;
  // From rest to rest damping spends nothing: at half of what it bore before the wall would have worked against it.
  stop_damping(*model_, state_.wall);
  const bool found = try_step(poses, poses, kAtOnce * options_.time_step, input);
  snaps_ = false;
  state_.books.numerical = before.numerical;
  state_.books.tool_work = before.tool_work;
  return found;
}

double Body::come_to_rest() {
  // The steps before tell nothing about those to come.
  state_.previous_step = 0;
  state_.outflow = state_.exchange = {};
  state_.velocity.setZero();
  state_.acceleration.setZero();
  state_.previous_velocity.setZero();
  state_.previous_position = state_.equilibrium.position;
  state_.fluid_motion = fluid_at_rest(*model_, state_);
  return std::exchange(state_.books.kinetic, 0);
}

void Body::leave_punctures(std::span<const ToolPose> poses) {
  bool left = false;
  for (Puncture& puncture : state_.punctures) {
    if (!puncture.tool) continue;
    const ToolPose& pose = poses[*puncture.tool];
    for (ShaftPoint& point : puncture.points) {
      const Eigen::Vector3d place = state_.equilibrium.position.segment<3>(3 * point.vertex);
      const double behind = pose.direction.dot(pose.tip - place);
      if (!point.touches || behind > kNeedleTip * needle_cone(tools_[*puncture.tool])) continue;
      point.touches = false;
      left = true;
    }
    if (puncture.is_sealed()) continue;
    puncture.force.setZero();
    if (is_clear_of(puncture, pose)) puncture.tool.reset();
  }
  if (!left) return;
  hold_as_it_is(model_->edge_length, false, poses);
  measure_openings(*model_, state_);
}

void Body::take_needle_out(int tool, std::span<const ToolPose> poses) {
  bool left = false;
  for (Puncture& puncture : state_.punctures) {
    if (puncture.tool != tool) continue;
    left = left || puncture.is_sealed();
    for (ShaftPoint& point : puncture.points) point.touches = false;
    puncture.force.setZero();
    puncture.tool.reset();
  }
  if (!left) return;
  hold_as_it_is(model_->edge_length, false, poses);
  measure_openings(*model_, state_);
}

bool Body::is_clear_of(const Puncture& puncture, const ToolPose& pose) const {
  std::vector<char> marks(model_->triangles(), 0);
  mark_free(*model_, puncture, marks);
  for (const ToolSolid& solid : tool_solids(tools_[*puncture.tool], pose)) {
    for (int t = 0; t < model_->triangles(); ++t) {
      if (!marks[t]) continue;
      const auto corners = corners_of(model_->surface[t], state_.equilibrium.position);
      // A wall that snaps back aside when its lips are let go may have the tip in the middle of a triangle.
      if (is_through(corners, pose)) return false;
      for (const Eigen::Vector3d& corner : corners) {
        if (signed_distance(solid, corner).value < solid.sharpness()) return false;
      }
    }
  }
  return true;
}

Body::ShaftOpening Body::open_on_shaft(std::span<const ToolPose> poses, double most_imbalance) {
  const int tool = *state_.punctures.back().tool;
  const std::vector<char> is_free = free_triangles(*model_, state_.punctures, tool);
  for (std::size_t solid = 0; solid < solids_.size(); ++solid) {
    if (solids_[solid] != tool) continue;
    for (std::size_t site = 0; site < model_->sites.size(); ++site) {
      if (is_free[model_->sites[site].triangle]) state_.solid_forces[solid][site] = 0;
    }
    std::erase_if(state_.friction[solid], [&](const FrictionMemory& memory) { return is_free[memory.triangle]; });
  }
  double reached = 0, next = 0, step = kSpreadStep;
  while (reached < 1) {
    state_.punctures.back().spread = next;
    if (snap(poses)) {
      // What is spread on takes up more and more.
      if (state_.books.imbalance() > most_imbalance) return ShaftOpening::kDoesNotPay;
      reached = next;
      // Friction begins with what the needle does from now on.
      for (ShaftPoint& point : state_.punctures.back().points) {
        point.anchor =
            poses[tool].direction.dot(poses[tool].tip - state_.equilibrium.position.segment<3>(3 * point.vertex));
        point.friction = 0;
        if (reached < 1) point.limit = 0;
      }
    } else {
      step *= 0.5;
      if (next == 0 || step < kLeastSpreadStep) return ShaftOpening::kJams;
    }
    next = std::min(1.0, reached + step);
  }
  return ShaftOpening::kOpens;
}

bool Body::make_slit(const CutPath& path, double radius, Cut& cut, Uncut& before) {
  for (const double edge : kSlitEdges) {
    if (before.model) put_back(std::exchange(before, {}));
    cut = change_mesh(path, {.edge_length = edge * radius}, &before);
    if (std::abs(cut.length - 2 * radius) <= kSlitGive * 2 * radius) break;
  }
  const bool is_slit = !cut.triangles.empty() && cut.lips.size() == 1 && cut.lips[0].left.size() > 2;
  if (!is_slit && before.model) put_back(std::exchange(before, {}));
  return is_slit;
}

std::optional<Rupture> Body::pierce(int tool, std::span<const ToolPose> poses) {
  leave_punctures(poses);
  Pressing& pressing = state_.pressing[tool];
  if (pressing.recedes) return std::nullopt;
  const double radius = tools_[tool].radius, work = pressing.work, residual = report_.residual;
  const auto place = pressed_place(*model_, state_.equilibrium.position, poses[tool], radius,
                                   free_triangles(*model_, state_.punctures, tool));
  if (!place) return std::nullopt;
  const double cost = model_->cut_cost(place->triangle), of_slit = 2 * radius * cost;  // newton, joule
  if (work < std::max(kLeastWork * of_slit, pressing.awaited)) return std::nullopt;
  const auto await = [&](double more, const std::string& why) {
    state_.pressing[tool].awaited = work + more;
    if (why.empty() || work < kMostWork * of_slit) return;
    throw SimulationFailure("body `" + model_->definition.name + "`: needle `" + tools_[tool].name +
                            "` presses hard enough to go through the wall, but " + why);
  };
  // The first cut of a body replaces its model, on which the slits are sought.
  if (!surface_) prepare_cutting();
  const EnergyBooks books = state_.books;
  const std::vector<ToolContact> felt = state_.contacts;
  Rupture rupture;
  Uncut before;
  ShaftOpening opening = ShaftOpening::kJams;
  int jams = 0;
  const auto fits = [&](const CutPath& path) {
    if (!make_slit(path, radius, rupture.cut, before)) return false;
    rupture.cost = cost * rupture.cut.length;
    state_.punctures.push_back(puncture_of(*model_, rupture.cut, tool, poses[tool], radius));
    opening = open_on_shaft(poses, books.imbalance() - rupture.cost);
    if (opening != ShaftOpening::kJams) return true;
    put_back(std::exchange(before, {}));
    report_.residual = residual;
    return ++jams == kMostJams;
  };
  try_slits(*model_, *place, poses[tool], radius, fits);
  if (opening == ShaftOpening::kJams) {
    await(kRetryPart * of_slit, jams > 0 ? "the wall around it finds no equilibrium: " + failure_
                                         : "no slit of its width fits in there; aim farther from borders and cuts");
    return std::nullopt;
  }
  rupture.released = books.imbalance() - state_.books.imbalance();
  if (opening == ShaftOpening::kDoesNotPay) {
    put_back(std::move(before));
    report_.residual = residual;
    await(kMissingPart * (rupture.cost - rupture.released), {});
    return std::nullopt;
  }
  book_rupture(tool, rupture, felt);
  return rupture;
}

void Body::book_rupture(int tool, const Rupture& rupture, const std::vector<ToolContact>& felt) {
  // The tools felt the wall as it was until now.
  state_.contacts = felt;
  const double kinetic = come_to_rest();
  state_.books.fracture += rupture.cost;
  state_.books.jump += rupture.released + kinetic - rupture.cost;
  state_.pressing[tool] = {};
}

void Body::put_back(Uncut before) {
  surface_ = std::move(before.surface);
  model_ = std::move(before.model);
  newton_ = std::move(before.newton);
  state_ = std::move(before.state);
}

}  // namespace thinwall
