// What needles that pierce do within a step: they go through walls that are held fast, and have the step divided where
// a stiff wall would let them work far more than a slit costs.
//
// A wall that cannot give way before a needle bears any force, and stores none of its work: no energy balance says when
// it gives way. So a needle that pierces does not feel what is held in its way, until it is out of it again. It goes in
// at once, and pays for the slit as its cone spreads it: the cost, evenly over the length of the cone. That is what the
// needle feels there, whatever the step. What cannot move does not squeeze its shaft. Nor does a blade that incises
// feel what is held, until it is out of it: it dents what is free beside it, and goes in by the work that this asks.

#include <algorithm>
#include <utility>

#include "engine/equilibrium/HeldWall.hpp"
#include "engine/simulation/Body.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "engine/tool/ToolSolids.hpp"

namespace thinwall {
namespace {

/// Work over the cost of a slit that a needle may do in a part of a step.
constexpr double kMostPartWork = 0.5;

}  // namespace

void Body::note_passing(std::span<const int> tools, std::span<const ToolPose> poses, std::vector<int>& passing) const {
  std::erase_if(passing, [&](int tool) {
    return std::ranges::find(tools, tool) == tools.end() && step_contacts().is_out_of_wall(tool, poses[tool]);
  });
  for (const int tool : tools) {
    const auto at = std::ranges::lower_bound(passing, tool);
    if (at == passing.end() || *at != tool) passing.insert(at, tool);
  }
}

bool Body::needles_overshoot(const BodyState& before, std::span<const ToolPose> poses) const {
  return std::ranges::any_of(state_.piercing, [&](int tool) {
    const double work = state_.pressing[tool].work - before.pressing[tool].work;
    if (work <= 0 || state_.pressing[tool].recedes) return false;
    const double radius = tools_[tool].radius;
    const auto place = pressed_place(*model_, state_.equilibrium.position, poses[tool], radius,
                                     free_triangles(*model_, state_.punctures, tool));
    return place && work > kMostPartWork * 2 * radius * model_->cut_cost(place->triangle);
  });
}

void Body::pierce_within_step(std::span<const ToolPose> poses) {
  for (const int tool : state_.piercing) {
    StepRupture made{.tool = tool, .uncut = model_->definition.mesh};
    std::optional<Rupture> rupture = pierce(tool, poses);
    if (!rupture) continue;
    made.rupture = *std::move(rupture);
    made.felt = state_.contacts[tool];
    report_.ruptures.push_back(std::move(made));
  }
}

void Body::tell_ruptures_within_step() {
  for (const StepRupture& one : report_.ruptures) {
    if (one.felt) state_.contacts[one.tool] = *one.felt;
  }
}

void Body::go_through_held_wall(std::span<const ToolPose> begin, std::span<const ToolPose> end) {
  for (const int tool : state_.piercing) {
    const ToolPose &from = begin[tool], &to = end[tool];
    if ((to.tip - from.tip).dot(to.direction) <= 0) continue;
    // From where it is thick enough to be felt to its other end.
    const double behind = kNeedleTip * needle_cone(tools_[tool]);
    const auto place = held_crossing(*model_, state_.equilibrium.position, to.tip - behind * to.direction,
                                     to.tip - tools_[tool].length * to.direction, held_against(*model_, to.direction),
                                     free_triangles(*model_, state_.punctures, tool));
    if (place) slit_held_wall(tool, *place, end);
  }
  pay_for_held_slits(begin, end);
}

void Body::slit_held_wall(int tool, const SurfacePoint& place, std::span<const ToolPose> poses) {
  const auto fail = [&](const std::string& why) {
    throw SimulationFailure("body `" + model_->definition.name + "`: needle `" + tools_[tool].name +
                            "` goes into a wall that is held fast there, but " + why);
  };
  // The first cut of a body replaces its model, on which the slits are sought.
  if (!surface_) prepare_cutting();
  const double radius = tools_[tool].radius, residual = report_.residual, cost = model_->cut_cost(place.triangle);
  const EnergyBooks books = state_.books;
  const std::vector<ToolContact> felt = state_.contacts;
  StepRupture made{.tool = tool, .uncut = model_->definition.mesh};
  Uncut before;
  const auto fits = [&](const CutPath& path) { return make_slit(path, radius, made.rupture.cut, before); };
  if (!try_slits(*model_, place, poses[tool], radius, fits)) {
    fail("no slit of its width fits in; aim farther from borders and cuts");
  }
  made.rupture.cost = cost * made.rupture.cut.length;
  state_.punctures.push_back(puncture_of(*model_, made.rupture.cut, tool, poses[tool], radius));
  state_.punctures.back().due = made.rupture.cost;
  if (open_on_shaft(poses) == ShaftOpening::kJams) {
    put_back(std::move(before));
    fail("the wall around it finds no equilibrium: " + failure_);
  }
  report_.residual = residual;
  state_.contacts = felt;
  // The tip that has gone in has spread the lips as far as it is thick; or the wall has come to rest, and lost.
  const double released = books.imbalance() - state_.books.imbalance() + come_to_rest();
  made.rupture.released = std::max(0.0, released);
  state_.books.jump += made.rupture.released;
  state_.books.tool_work += made.rupture.released - released;
  state_.pressing[tool] = {};
  report_.ruptures.push_back(std::move(made));
}

void Body::pay_for_held_slits(std::span<const ToolPose> begin, std::span<const ToolPose> end) {
  for (Puncture& puncture : state_.punctures) {
    if (puncture.due == 0 || !puncture.tool) continue;
    const int tool = *puncture.tool;
    const double motion = (end[tool].tip - begin[tool].tip).dot(end[tool].direction);
    if (motion <= 0) continue;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const ShaftPoint& point : puncture.points) middle += state_.equilibrium.position.segment<3>(3 * point.vertex);
    middle /= static_cast<double>(puncture.points.size());
    const double behind = end[tool].direction.dot(end[tool].tip - middle) / needle_cone(tools_[tool]);
    const double spread = std::clamp((behind - kNeedleTip) / (1 - kNeedleTip), 0.0, 1.0);
    if (spread <= puncture.paid) continue;
    const double work = puncture.due * (spread - std::exchange(puncture.paid, spread));
    state_.books.fracture += work;
    state_.books.tool_work += work;
    state_.contacts[tool].force -= work / motion * end[tool].direction;
    state_.contacts[tool].touching = true;
  }
}

}  // namespace thinwall
