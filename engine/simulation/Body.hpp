#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/cutting/CutSurface.hpp"
#include "engine/equilibrium/BodyModel.hpp"
#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/equilibrium/Newton.hpp"
#include "engine/simulation/BladeWay.hpp"
#include "engine/simulation/BodyState.hpp"
#include "engine/simulation/BodyStepReport.hpp"
#include "engine/simulation/CutProgress.hpp"
#include "engine/simulation/PassedTools.hpp"
#include "engine/simulation/Puncture.hpp"
#include "engine/simulation/SimulationOptions.hpp"
#include "engine/simulation/StepContacts.hpp"
#include "engine/simulation/ToolResponse.hpp"
#include "engine/tool/FirstContact.hpp"
#include "engine/tool/Tool.hpp"
#include "engine/tool/ToolSolids.hpp"

namespace thinwall {

/// What a script does to the fluid of a chamber during a step.
struct FluidInput {
  double added = 0;                // metres^3, less than zero where it is drained
  std::optional<double> pressure;  // pascal at the end of the step: the volume of the fluid follows
};

/// What a script puts into a body during a step.
struct BodyInput {
  std::vector<double> load_factors;      // (loads) at the end of the step; 1 where it is shorter
  std::vector<FluidInput> fluids;        // (chambers); nothing where it is shorter
  std::optional<BladeInput> blade = {};  // that is in the wall
  std::vector<int> needles = {};         // tools, that pierce: what they then do within the step, see StepRupture
  std::vector<int> blades = {};          // tools, that incise, in the wall or not yet: what is held does not stop them
};

/// How hard an equilibrium is tried.
struct SolveEffort {
  std::optional<int> most_iterations = {};  // if fewer than the options'
  std::optional<double> tolerance = {};     // if looser than the options'
  bool takes_flaps = false;                 // see NewtonOptions; always in cut walls
  bool buckles = false;                     // see NewtonOptions
};

/// One body with its solver. Not copyable; bodies do not touch each other.
class Body {
 public:
  Body(BodyDefinition definition, std::vector<ToolDefinition> tools, SimulationOptions options);

  /// Finds the equilibrium before time zero under the given pressure, prestretch and gravity, with the loads at these
  /// factors; a viscous wall is taken to have rested there for long. Throws SimulationFailure.
  void settle(std::vector<double> load_factors = {});

  /// Moves the tools from one set of poses to the next, (tools) each, and brings the body there in `duration` seconds,
  /// while the script puts in `input`, evenly. Throws SimulationFailure when the step cannot be saved; the state is
  /// then the one before.
  void advance(std::span<const ToolPose> begin, std::span<const ToolPose> end, double duration,
               const BodyInput& input = {});

  const BodyModel& model() const { return *model_; }
  const BodyState& state() const { return state_; }
  const BodyStepReport& report() const { return report_; }
  SurfaceView surface() const { return surface_of(*model_, state_); }

  /// Pairs of parts of the wall that lie on each other, after the last step.
  std::size_t fold_count() const { return newton_->terms().folds.folds.size(); }

  /// Force with which the jaws of forceps press on this body from both sides: the smaller of the two along x', newton.
  double squeeze(int tool, const ToolPose& pose) const;

  /// Cuts the wall along a path on it and changes nothing else: nothing has moved, and the lips are held together until
  /// a blade moves on (see CutProgress). A part that comes off keeps contents of its own where it can hold any (see
  /// PartedContents). Throws std::invalid_argument when the wall is no oriented manifold, or the path leaves it.
  /// Asserts that the wall has a toughness.
  Cut cut(const CutPath& path, std::span<const ToolPose> poses);

  /// Cuts the wall to where the line of a blade's edge, through its tip along its direction, meets it now: from the tip
  /// of the cut that is being made, or from where the blade met the wall first. Nothing where the blade is not in the
  /// wall, or has not come far enough for a cut that leaves no sliver. `poses`: (tools), at the end of the last step.
  /// `goes_on`: whether the blade will come farther, so that the cut may wait rather than end beside its way.
  std::optional<Cut> follow_blade(int tool, std::span<const ToolPose> poses, bool goes_on = true);

  /// Takes a blade that stands between the lips of an opening for one that has gone in: it cuts on from the lip that
  /// lies ahead of it. `way`: unit, of the blade. Nothing happens where wall lies on the line of the blade's edge, or a
  /// mean edge length below it, or no lip lies ahead.
  void enter_gap(int tool, const ToolPose& pose, const Eigen::Vector3d& way);

  /// Lets the cut of the blade in the wall run on before it, by the length of about one edge, where that pays: where
  /// the wall at rest, with all lips free, would release more energy than the new area costs. The lips are then let go
  /// in some steps; what they release beyond the cost is a jump. Nothing where it does not pay, where lips have
  /// released too little on the blade's way so far for that to be likely, or where the cut has run in this step as far
  /// as it may: by the blade's width, or two edges if that is more. To be called after each step, until it gives
  /// nothing. `ahead`: where the blade will be so many metres farther on its way, and the cut goes to where its edge
  /// would meet the wall then. `straight_on`: metres from where on it is as much deeper. `poses`: (tools), at the end
  /// of the step. Throws as `cut` does.
  std::optional<Cut> run_ahead(std::span<const ToolPose> poses, const std::function<ToolPose(double)>& ahead,
                               double straight_on = std::numeric_limits<double>::infinity());

  /// Ends the cut that is being made: the next one begins where a blade meets the wall again.
  void leave_cut();

  /// A needle that is set elsewhere is in its punctures no more. `poses`: (tools), as they are then.
  void take_needle_out(int tool, std::span<const ToolPose> poses);

  /// Lets the wall give way to a needle where that pays: once wall, fluid and weight together release more, at this
  /// pose, than a slit of the needle's width costs, with the slit spread on the shaft and the wall free to slide on it.
  /// The wall is then at rest in that equilibrium, and slides along the shaft under friction from then on; what was
  /// released beyond the cost is a jump. A puncture lets nothing through while the needle is in it, and is left open
  /// when its tip has gone back out. To be called after each step in which the needle may press or go back. `poses`:
  /// (tools), at the end of the step. Where a cut or a border leaves no room for the slit it is made beside the
  /// needle's point, and the wall drawn onto the shaft. Throws as `cut` does, and SimulationFailure where the needle
  /// has done several times the work that a slit costs and none fits in, or the wall finds no equilibrium on the shaft.
  std::optional<Rupture> pierce(int tool, std::span<const ToolPose> poses);

  /// What the body does to a tool now, and how that changes with small motions of the tool, while fluid flows for
  /// `duration` seconds and a wall in motion follows; of friction the force alone. Nothing but the pose where the tool
  /// is farther than `reach`, metres, from the wall. `poses`: (tools), at the end of the last step. The next step
  /// begins where this answer leads. Throws SimulationFailure.
  ToolResponse respond(int tool, std::span<const ToolPose> poses, double duration, double reach);

  /// Pressure between wall and tools at each vertex, (vertices), pascal: force on the vertex over its area now.
  Eigen::VectorXd contact_pressure() const;

  /// Principal Cauchy stresses in the middle plane of the wall, (2 x triangles), pascal, the larger first: what the
  /// wall bears now, with what viscosity adds. Of a shell the part of the membrane, without that of bending.
  Eigen::Matrix2Xd principal_stress() const {
    return thinwall::principal_stress(*model_, state_.equilibrium.position, state_.wall);
  }

 private:
  /// What a cut has replaced.
  struct Uncut {
    std::unique_ptr<CutSurface> surface;
    std::unique_ptr<const BodyModel> model;
    std::unique_ptr<Newton> newton;
    BodyState state;
  };

  /// Where the answer to a tool's motion leads, to first order.
  struct Foresight {
    struct Site {
      int solid = 0, site = 0;
      Eigen::Matrix<double, 1, 6> force_by_motion;  // newton / metre, newton
    };
    int tool = 0;
    Eigen::Matrix<double, Eigen::Dynamic, 6> motion;  // (unknowns x 6), of the body by that of the tool
    std::vector<Site> sites;
  };

  /// What the last step did to the solution.
  struct LastStep {
    std::vector<Eigen::Vector3d> way;  // (tools), metres, of their tips
    EquilibriumState before;
    std::vector<std::vector<double>> solid_forces;  // (solids x sites), newton, before it
  };

  /// What the needles in punctures have done in a step, joule.
  struct ShaftBooks {
    double stored = 0, friction = 0, tool_work = 0;
  };

  NewtonResult solve(EquilibriumProblem& problem, EquilibriumState& state, const SolveEffort& effort = {});
  /// `way`: where the wall and the tools set out, for solutions that go through none of these at once.
  NewtonResult relax(EquilibriumProblem& problem, EquilibriumState& state, std::optional<WayStart> way = {},
                     bool is_eager = false);
  /// Lets go of weak springs that a wall at `state` was held with; nothing where that does not do. `held`: their last
  /// solution, where it was taken, with which a wall is left that need not come to rest.
  std::optional<NewtonResult> rest_without_springs(EquilibriumProblem& problem, EquilibriumState& state,
                                                   const std::optional<WayStart>& way, const NewtonResult* held);
  bool is_turned_by_loads(const EquilibriumProblem& problem, const EquilibriumState& state) const;
  /// From an equilibrium with held rigid motions to where the loads have no moment that these hold against.
  bool turn(const EquilibriumProblem& problem, EquilibriumState& state);
  bool find_turned(EquilibriumProblem& problem, EquilibriumState& state);
  void turn_to_rest(EquilibriumProblem& problem, EquilibriumState& state);
  /// Pascal under which a chamber holds a volume, metres^3; nothing where that is not found.
  std::optional<double> pressure_at(double volume, int chamber, const EquilibriumProblem& whole,
                                    EquilibriumState& state);
  struct MostBorne {
    int chamber = 0;
    double pressure = 0;  // pascal
  };
  /// The largest pressure that the one chamber with a given pressure bears, up to so many times its volume; nothing
  /// where it bears the given one, or it is not found out. With its volume given a wall is stable beyond the limit
  /// point.
  std::optional<MostBorne> most_borne(const EquilibriumProblem& whole, double most_volume,
                                      const EquilibriumState& grown);
  NewtonResult burst(const std::optional<MostBorne>& most = {});
  /// What tells, on the way to an equilibrium, that a body grows without end.
  struct Growth {
    double had = 0;        // metres^3 that it enclosed at first
    double most_area = 0;  // metres^2, of a wall that a pressure loads
    double asked_at = 0;   // times the volume from which on it is asked whether the wall bears the pressure
  };
  Growth growth_from(const EquilibriumProblem& problem, const EquilibriumState& state) const;
  /// Nothing as long as it does not.
  std::optional<NewtonResult> burst_of(Growth& growth, const EquilibriumProblem& problem,
                                       const EquilibriumState& state);
  /// No solution, for this reason, which is kept.
  NewtonResult fail(const std::string& reason);
  /// Solves a slack wall again from where it has come to; it stays there where that fails.
  void settle_slack(EquilibriumProblem& problem, EquilibriumState& state);
  void solve_statics();
  bool load_slowly(const EquilibriumProblem& whole, EquilibriumState& trial);
  std::string describe_failure() const;
  bool has_inertia() const { return options_.analysis == Analysis::kDynamic && !snaps_; }
  bool may_snap() const;
  bool may_creep() const;
  bool is_left_slack() const;
  /// Whether a wall that gives way need not come to rest altogether, as the steps after can go on with that.
  bool leaves_rest_to_steps() const;
  bool may_crumple() const;
  /// From now on the wall wrinkles infinitely finely where it is pressed along itself, as a cut one does.
  void crumple(std::span<const ToolPose> poses);
  bool creep(EquilibriumProblem& problem, EquilibriumState& trial, const std::optional<WayStart>& way);
  void find_drag(const Eigen::VectorXd& before);
  /// `goes_on`: whether `trial` is a solution of the same part of the step that friction or fluids have been revised
  /// from, rather than a guess.
  bool solve_step(EquilibriumProblem& problem, EquilibriumState& trial, std::span<const ToolPose> begin, bool goes_on);
  bool try_step(std::span<const ToolPose> begin, std::span<const ToolPose> end, double duration,
                const BodyInput& input);
  /// The way of `advance` from `start`, in parts where that is asked for; throws part way.
  void advance_in_parts(const BodyState& start, std::span<const ToolPose> begin, std::span<const ToolPose> end,
                        double duration, const BodyInput& input);
  /// Takes a step back in which lips came to drive the wall; they are marked in `before`, where the body is then.
  bool takes_back_driven(BodyState& before);
  /// Whether a step is given up after so many failures in a row.
  bool is_hopeless(int failed) const;
  bool is_spent() const { return report_.newton_iterations > options_.maximum_step_iterations; }
  [[noreturn]] void give_up() const;
  /// From where the body is, where its wall is a tension field in statics.
  LeastMotion least_motion() const;
  EquilibriumProblem make_problem(std::span<const ToolPose> end, double duration, const BodyInput& input) const;
  void add_fluids(double duration, const BodyInput& input, EquilibriumProblem& problem) const;
  bool draw_air(EquilibriumProblem& problem, EquilibriumState& trial, std::span<const ToolPose> begin);
  bool solve_with_leaks(EquilibriumProblem& problem, EquilibriumState& trial, std::span<const ToolPose> begin,
                        double duration);
  /// Whether what is found by `solve_with_leaks` may be an equilibrium that is not stable, and is to be left.
  bool may_buckle(const EquilibriumProblem& problem) const;
  bool find_buckled(EquilibriumProblem& problem, EquilibriumState& trial);
  /// Leaves such an equilibrium for a stable one. Where none is found all stays as it is, and the report tells.
  void buckle(EquilibriumProblem& problem, EquilibriumState& trial);
  StepContacts step_contacts() const { return {*model_, state_, tools_}; }
  void prepare_cutting();
  void find_forces(std::span<const ToolPose> poses);
  /// Begins on the way that the wall was last on, where least is missed.
  void begin_as_moving(double duration, EquilibriumProblem& problem, EquilibriumState& trial) const;
  void begin_as_foreseen(std::span<const ToolPose> begin, std::span<const ToolPose> end, EquilibriumProblem& problem,
                         EquilibriumState& trial) const;
  /// Begins where the last step leads on to, as far as the tools go on as they did in it; false where they do not.
  bool begin_as_extrapolated(std::span<const ToolPose> begin, std::span<const ToolPose> end,
                             EquilibriumProblem& problem, EquilibriumState& trial) const;
  void note_last_step(std::span<const ToolPose> begin, std::span<const ToolPose> end);
  EquilibriumProblem response_problem(std::span<const ToolPose> poses, double duration) const;
  void add_contacts_to(ToolResponse& response, const EquilibriumProblem& problem, int tool);
  /// What the contacts answer to a unit of one of the six motions of the tool; the wall's motion, (unknowns), metres.
  Eigen::VectorXd add_motion_to(ToolResponse& response, const EquilibriumProblem& problem, int tool,
                                std::span<const ContactPoint* const> pressing, int axis);
  /// The nearest place of the wall; along its direction that of a point. Nothing of a line.
  WallAhead wall_ahead(int tool, const ToolPose& pose) const;
  WallAhead stiffness_ahead(WallAhead ahead, const EquilibriumProblem& problem, int tool, const ToolPose& pose);
  BladeWay way_of_blade(int tool) const { return {*model_, state_, tools_[tool]}; }
  /// Where the wall presses a blade most that has worked on it as much as a cut of its width costs: what it meets with
  /// its edge from the front it would push before it for ever. Nothing before that.
  std::optional<SurfacePoint> place_before(int tool, const ToolPose& pose) const;
  /// Begins another cut where a blade meets the wall far from the tip, as where a flap has taken the tip aside: no way
  /// over the wall leads from it to the blade, or none that the blade has gone.
  void begin_anew_far_off(int tool, const ToolPose& pose);
  std::optional<Cut> go_on(const WayOn& way, const ToolPose& pose, std::span<const ToolPose> poses);
  /// What the wall releases, joule, at rest with all lips free, where the cut goes on along a path, and what that
  /// costs; nothing where it finds no equilibrium or is not cut. Changes nothing.
  std::optional<Rupture> try_cut(const CutPath& path, std::span<const ToolPose> poses);
  /// Lets the cut run to where the blade will be at `pose`. `lead`: metres of the blade's way to the tip.
  std::optional<Cut> run(const WayOn& way, const ToolPose& pose, double lead, std::span<const ToolPose> poses);
  void begin_cut(const SurfacePoint& place);
  /// Looks for where a blade that has left the wall comes back into it.
  void find_gap(const Cut& cut, const Eigen::Vector3d& left, const Eigen::Vector3d& way, const ToolPose& pose);
  /// Whether the blade has just met the far lip of the gap that it was in.
  bool come_out_of_gap(const ToolPose& pose);
  /// Triangles beside other tools stay as they are: an edge that is flipped there could lie in a tool.
  CutOptions options_of_blade(std::span<const ToolPose> poses) const;
  Cut change_mesh(const CutPath& path, CutOptions options, Uncut* before = nullptr);
  void put_back(Uncut before);
  /// Adds tools to those that pass what is held in their way, and takes off those that are out of it.
  void note_passing(std::span<const int> tools, std::span<const ToolPose> poses, std::vector<int>& passing) const;
  bool needles_overshoot(const BodyState& before, std::span<const ToolPose> poses) const;
  void pierce_within_step(std::span<const ToolPose> poses);
  void tell_ruptures_within_step();
  void go_through_held_wall(std::span<const ToolPose> begin, std::span<const ToolPose> end);
  void slit_held_wall(int tool, const SurfacePoint& place, std::span<const ToolPose> poses);
  void pay_for_held_slits(std::span<const ToolPose> begin, std::span<const ToolPose> end);
  ShaftBooks book_shafts(const EquilibriumProblem& problem, std::span<const ToolPose> begin);
  void track_pressing(const BodyState& before, std::span<const ToolPose> begin, const EquilibriumProblem& problem);
  bool snap(std::span<const ToolPose> poses);
  double come_to_rest();
  void leave_punctures(std::span<const ToolPose> poses);
  bool is_clear_of(const Puncture& puncture, const ToolPose& pose) const;
  enum class ShaftOpening { kOpens, kDoesNotPay, kJams };
  /// Spreads the last slit on the shaft of its needle, by and by, while the books miss no more than `most_imbalance`,
  /// joule: beyond that the wall has released less than the slit costs.
  ShaftOpening open_on_shaft(std::span<const ToolPose> poses,
                             double most_imbalance = std::numeric_limits<double>::infinity());
  bool make_slit(const CutPath& path, double radius, Cut& cut, Uncut& before);
  void book_rupture(int tool, const Rupture& rupture, const std::vector<ToolContact>& felt);
  /// Where the mesh or what presses on the wall has changed: the forces that are missing now hold it as it is, and are
  /// let go with the cut's length, metres, rest; `pays`: see HeldLips.
  void hold_as_it_is(double length, bool pays, std::span<const ToolPose> poses);
  /// Takes off what holds lips all that would move a part of the wall as a whole which nothing holds: what was left of
  /// the wall between it and the rest bore that, and is cut.
  void let_free_parts_go();
  void hold_dent(int tool, std::span<const ToolPose> poses);
  /// Cost of new cut area per length, newton: of the triangle, at a vertex the mean of those around.
  double cost_at(const SurfacePoint& place) const;
  double way_of_wall(const BladeInput& blade, const Eigen::VectorXd& motion) const;
  double book_cut(const CutProgress& before, const Eigen::VectorXd& motion, const std::optional<BladeInput>& blade);
  bool solve_with_friction(EquilibriumProblem& problem, EquilibriumState& trial, std::span<const ToolPose> begin,
                           bool goes_on);
  double gravity_energy() const;
  double rate(const OrificeDefinition& orifice, const BodyState& state) const;
  void add_inertia(double duration, EquilibriumProblem& problem) const;
  void accept(std::span<const ToolPose> begin, double duration, const EquilibriumProblem& problem,
              const BodyInput& input, const EquilibriumState& reached);
  void update_fluids(double duration, const BodyInput& input, const EquilibriumProblem& problem);
  void update_velocity(const BodyState& before, double duration);
  void update_forces(const EquilibriumProblem& problem);
  void update_books(const BodyState& before, std::span<const ToolPose> begin, double duration,
                    const EquilibriumProblem& problem, const BodyInput& input);
  void book_stored(double on_shafts);
  double work_of_solids(const BodyState& before, std::span<const ToolPose> begin,
                        const EquilibriumProblem& problem) const;
  double book_fluids(const BodyState& before);
  FluidMode fluid_mode() const;

  std::unique_ptr<const BodyModel> model_;
  std::vector<ToolDefinition> tools_;
  SimulationOptions options_;
  std::vector<int> solids_;  // (solids of all tools), their tool
  std::unique_ptr<Newton> newton_;
  std::unique_ptr<CutSurface> surface_;  // none before the first cut
  BodyState state_;
  BodyStepReport report_;
  std::optional<Foresight> foresight_;     // for the next step
  std::optional<LastStep> last_step_;      // if its solution is to be extrapolated
  bool snaps_ = false;                     // whether a wall gives way at once, from one equilibrium to another
  std::optional<double> trial_tolerance_;  // for forces, while an equilibrium is tried for its energy alone
  bool is_loose_ = false;                  // whether the last solution's residual is above the tolerance
  bool is_convex_ = true;                  // whether it was found with the curvature as it is
  bool is_unstable_ = false;               // whether the equilibrium of the step under way is not stable
  bool bursts_ = false;                    // whether the last attempt has been found to burst
  bool stays_held_ = false;                // whether loads did not turn it to rest where they were to
  std::string failure_;                    // why the last attempt failed
};

}  // namespace thinwall
