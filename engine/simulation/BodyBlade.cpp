// A blade in the wall of a body: where it meets it, what it costs to go on, and who pays for what it cuts.

#include <algorithm>
#include <limits>

#include "engine/contact/SolidGap.hpp"
#include "engine/cutting/SurfaceTrace.hpp"
#include "engine/equilibrium/FrictionContact.hpp"
#include "engine/simulation/Body.hpp"

namespace thinwall {
namespace {

/// Mean edge lengths over which the energy that lips release is told to the blade.
constexpr double kSettledEdges = 2;

/// Part of the cost of new cut area that a blade feels at most while it pays for what the mesh was cut beyond its way,
/// as where a cut begins at a vertex behind it.
constexpr double kMostResistance = 1.1;

/// Mean edge lengths that a blade has been charged for beyond what has been cut, from which on it cuts nothing: it goes
/// back along its own wound.
constexpr double kMostLead = 2;

/// Mean edge lengths of what has been cut that a blade may be in arrears with, as the mesh is cut some way at a time.
/// Where a flap turns against the blade, or folds, more is cut than it goes: it pays the rest over so many edges.
constexpr double kArrears = 1;
constexpr double kArrearsPaid = 0.5;

/// How much farther than its own way a blade may seem to go through a wall that springs back against it: lips are let
/// go by that way, and such a wall would spring back the faster the more is let go, however short the steps.
constexpr double kMostProgress = 8;

/// Work of the wall against what holds its lips, joule.
struct LipWork {
  double released = 0;  // of lips that pay for new cut area
  double lost = 0;      // of the others
};

/// Adds the work against half the forces of `cut`: half those before a step and half those after it make its work.
void add_half_work(const CutProgress& cut, const Eigen::VectorXd& motion, LipWork& work) {
  for (const HeldLips& lips : cut.held) {
    double& share = lips.pays ? work.released : work.lost;
    for (const HeldForce& one : lips.forces) {
      share -= 0.5 * lips.held * one.force.dot(motion.segment<3>(3 * one.vertex));
    }
    for (const HeldTurn& one : lips.turns) share -= 0.5 * lips.held * one.force * motion[one.unknown];
  }
}

}  // namespace

std::optional<SurfacePoint> Body::place_before(int tool, const ToolPose& pose) const {
  const std::vector<ToolSolid> solids = contact_solids(tools_[tool], pose);
  const std::size_t first = std::ranges::find(solids_, tool) - solids_.begin();
  double most = 0;  // newton
  std::optional<SurfacePoint> place;
  for (std::size_t k = 0; k < solids.size(); ++k) {
    const std::vector<double>& forces = state_.solid_forces[first + k];
    for (std::size_t s = 0; s < forces.size(); ++s) {
      if (forces[s] <= most) continue;
      const ContactSite& site = model_->sites[s];
      const auto corners = corners_of(model_->surface[site.triangle], state_.equilibrium.position);
      const auto gap = solid_gap(solids[k], std::numeric_limits<double>::infinity(), corners, site.part, site.corner,
                                 GapTerms::kGradient);
      most = forces[s];
      place = SurfacePoint{.triangle = site.triangle, .weights = gap->weights};
    }
  }
  if (!place || state_.pressing[tool].work < cost_at(*place) * tools_[tool].width) return std::nullopt;
  return snapped_to_edges(surface(), *place);
}

void Body::begin_anew_far_off(int tool, const ToolPose& pose) {
  const BladeWay way = way_of_blade(tool);
  const std::optional<SurfacePoint> place = way.place_below(pose);
  if (!place || !way.is_far(*place)) return;
  state_.cut.tip.reset();
  begin_cut(*place);
}

double Body::cost_at(const SurfacePoint& place) const {
  Eigen::Index corner = 0;
  if (place.weights.maxCoeff(&corner) < 1) return model_->cut_cost(place.triangle);
  const int vertex = model_->surface[place.triangle][corner];
  double sum = 0, count = 0;
  for (int t = 0; t < model_->triangles(); ++t) {
    if ((model_->surface[t].array() != vertex).all()) continue;
    sum += model_->cut_cost(t);
    count += 1;
  }
  return sum / count;
}

double Body::way_of_wall(const BladeInput& blade, const Eigen::VectorXd& motion) const {
  const CutProgress& cut = state_.cut;
  if (cut.tip) return blade.direction.dot(motion.segment<3>(3 * *cut.tip));
  if (!cut.start) return 0;
  return blade.direction.dot(place_on(*model_, cut.start->triangle, cut.start->weights, motion));
}

double Body::book_cut(const CutProgress& before, const Eigen::VectorXd& motion,
                      const std::optional<BladeInput>& blade) {
  CutProgress after = let_go(before, blade);
  LipWork lips;
  add_half_work(before, motion, lips);
  add_half_work(after, motion, lips);
  note_work(motion, after);
  double paid = 0;  // joule, by the blade
  if (blade && blade->travel > 0) {
    const double advance = std::max(0.0, blade->travel - way_of_wall(*blade, motion));
    // In its own wound, and where no wall is before it, it pays for what has been cut ahead of it, and no more.
    const double lead = after.is_in_wound || after.is_off_wall ? 0 : kMostLead * model_->edge_length * after.cost;
    const bool cuts = after.due > -lead;
    const double open = std::min(after.ahead, advance), cut = cuts ? advance - open : 0;
    paid = 0.5 * (before.push + after.push) * blade->travel;
    after.progress = std::min(advance / blade->travel, kMostProgress);
    after.ahead -= open;
    after.awaited = std::max(0.0, after.awaited - advance);
    after.owed += after.cost * cut - paid - lips.released;
    // Lips open by fits and starts, so what they release is smoothed and settled over the lengths of some triangles.
    const double length = kSettledEdges * model_->edge_length, share = std::min(1.0, cut / length);
    if (cut > 0) after.given += share * (lips.released / cut - after.given);
    const bool is_free = after.ahead > 0 || !cuts;
    after.resistance =
        is_free ? 0 : std::clamp(after.cost - after.given + after.owed / length, 0.0, kMostResistance * after.cost);
    const double arrears = unpaid(after) / model_->edge_length - kArrears * after.cost;  // newton
    if (!is_free && arrears > 0) after.resistance += arrears / kArrearsPaid;
    state_.contacts[blade->tool].force -= after.push * blade->direction;
    state_.contacts[blade->tool].touching = true;
  } else {
    after.owed -= lips.released;
  }
  // What the wall releases beyond the cost lightens the blade's work ahead; where there is none left it is lost.
  const bool is_work_ahead = blade && (after.resistance > 0 || after.is_in_wound || after.is_off_wall);
  const double credit = is_work_ahead ? 0 : std::max(0.0, -after.owed);
  after.owed += credit;
  after.due -= paid + lips.released;
  // Where a blade cut more than it went, it pays for that first.
  const double surplus = after.tool ? std::min(credit, std::max(0.0, -after.due)) : credit;
  EnergyBooks& books = state_.books;
  books.fracture += paid + lips.released - surplus;
  after.due += surplus;
  books.jump += surplus + lips.lost;
  books.tool_work += paid;
  state_.cut = after;
  return -lips.released - lips.lost;
}

}  // namespace thinwall
