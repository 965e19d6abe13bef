#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/equilibrium/FoldMatrix.hpp"
#include "engine/solver/BorderedSystem.hpp"
#include "engine/solver/SparseFactor.hpp"

namespace thinwall {

struct NewtonOptions {
  double tolerance = 1e-9;  // largest residual force over the largest single force
  int maximum_iterations = 60;
  // Flaps of a cut wall, and free borders, crumple without end: equilibria that are not stable, and residuals that only
  // round-off is left of, are taken too.
  bool takes_flaps = false;
  // Whether a step is found again with the same factor where its contacts change, not in shells alone, and one by one
  // where they go in circles; and whether the last step may be found with the factor of the one before: quicker, but
  // without the curvature that contacts take along, and right to the tolerance rather than to round-off.
  bool borders_contacts = false;
  // On the way of a wall that buckles: a shell is solved with the line search from the beginning, and where the matrix
  // has to be made convex what was needed for it last is tried first.
  bool buckles = false;
  std::function<void()> between_iterations = {};  // called before each; what it throws goes through
};

/// The unknowns of an equilibrium: where Newton starts, and what it has found.
struct EquilibriumState {
  Eigen::VectorXd position;        // (unknowns), metres
  Eigen::VectorXd pressure;        // (chambers), pascal
  Eigen::VectorXd rigid_reaction;  // (free rigid motions), newton, multipliers of a held free body
};

/// How an equilibrium answers a small force or motion, to first order.
struct LinearAnswer {
  Eigen::VectorXd motion;               // (unknowns), metres
  std::vector<Eigen::Vector3d> forces;  // (attachments), newton, changes of what the tissue does to the tools
};

struct NewtonResult {
  bool converged = false;
  int iterations = 0;
  double residual = 0;                   // newton, largest component at the end
  double force_scale = 0;                // newton, of which the tolerance is a part
  std::vector<double> residual_history;  // newton, before each iteration and at the end
  int shifted_iterations = 0;            // iterations whose matrix had to be made convex
  int factorisations = 0;                // of the matrix
  int in_single_precision = 0;           // of these
  int ascending_steps = 0;               // along which the line search's energy was to rise at first
  bool is_loose = false;                 // whether the residual is above the tolerance, see NewtonOptions::takes_flaps
  bool is_convex = true;                 // whether the last step was found with the curvature as it is, a convex one
  std::string reason;                    // why not converged
};

/// Newton's method with line search for one body. Keeps its memory and its analysed factor from call to call.
///
/// Unknowns beside the positions are multipliers: the pressure of an incompressible (or compressible) fluid and the
/// forces on a held free body border the sparse matrix; the forces at attachments come from the augmented matrix
/// K + gamma A^T A, which keeps its pattern because a material point couples the corners of one triangle only, by
/// Uzawa's iteration whose error shrinks by the ratio of the local stiffness to gamma.
///
/// Contacts are stiff springs between tool and wall whose forces are unknowns of their own: the curvature of a
/// contact takes the force that equilibrium gave it last, not the one that an overlap on the way to equilibrium would
/// ask for, which is larger by orders of magnitude and would make the matrix indefinite. A linear spring can pull, a
/// contact cannot: when contacts would pull they are taken to be open, when open ones would be overrun they are taken
/// to be closed, and the step is found again: the springs that differ from the factorised ones border the matrix too.
///
/// A thin shell is far stiffer along itself than across, and a step that is right to first order strains it to second
/// order, with stresses that dwarf the true ones. So a shell is first solved with the stresses as unknowns of their own
/// beside the displacements (Magisano, Leonetti and Garcea 2017, mixed integration points): eliminated in each triangle
/// they leave the equations as they are, but for the curvature, which takes the stress that the last step foresaw from
/// the strain it adds in first order. Whole steps are taken; where they do not lead to the end, the solution begins
/// again with the line search.
///
/// Where the wall comes to lie on itself or on its floor a potential keeps it from touching (see SelfContact), and the
/// line search starts from the longest step on which nothing touches. The exact curvature of these contacts is tried
/// first, their convex part when the whole is not convex with it.
///
/// A step is convex when the whole bordered matrix has one negative eigenvalue per constraint. Past a limit point K
/// alone is indefinite while the whole is convex, so K is then factorised as L D L^T and the inertia is counted; only
/// when the count is wrong is K shifted: in an open membrane at rest, while it is whole, by an even tension beside
/// weak springs, with which a dent in a slack flat wall spreads over all of it at once; springs alone let it grow ring
/// by ring, and where contents press or masses move they change little. In a cut wall, where that goes on for some
/// steps, the matrix is taken as it is: an equilibrium that symmetry keeps is found though it is not stable. How
/// chambers with openings are treated stands in OpenChambers, and how slack flaps are solved by themselves in
/// NewtonPatch.cpp.
///
/// Where there is inertia, factors that are large enough are in single precision, and what a step misses for it is
/// found again (see BorderedSystem); where that does not do, or says that the curvature is not convex, they are in
/// double.
class Newton {
 public:
  explicit Newton(const BodyModel& model);

  /// After a cut: `before` solved for the wall as it was, whose vertices come first; the wall is at `position`,
  /// (unknowns), metres.
  Newton(const BodyModel& model, const Newton& before, const Eigen::VectorXd& position);

  /// Solves from `state`; the attachments' forces in `problem` are both start and result. On failure the state is
  /// the best one reached.
  NewtonResult solve(EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options);

  /// What a state misses of an equilibrium, newton, by the measure in which steps are to lower it; infinite where the
  /// wall is stretched beyond its law.
  double missed(EquilibriumProblem& problem, EquilibriumState& state);

  /// Terms at a state, without solving.
  void look(const EquilibriumProblem& problem, const EquilibriumState& state) {
    evaluate_all(problem, state, false, terms_);
  }

  /// Factorises the curvature at an equilibrium that a solve has reached, with the contacts that press, and changes
  /// nothing else; false where it cannot be factorised. With `reuses_factor` that of the last step of the solve will
  /// do, if it ended with one: it is off by what that step changed.
  bool linearize(const EquilibriumProblem& problem, const EquilibriumState& state, bool reuses_factor = false);

  /// Whether an equilibrium that a solve has reached is stable: what tools and constraints hold held, no motion lowers
  /// the energy to second order.
  bool is_stable(const EquilibriumProblem& problem, const EquilibriumState& state);

  /// Goes from an equilibrium that is not stable along the motion that lowers the energy most, as far as it falls;
  /// false, with all as it was, where it does not. A solve from there finds another equilibrium.
  bool leave_saddle(EquilibriumProblem& problem, EquilibriumState& state);

  /// After `linearize`: what a small force, (unknowns), newton, and small motions of the targets of the attachments,
  /// (attachments), metres, do. Of chambers with openings the forces on the rims are left out.
  LinearAnswer answer(const EquilibriumProblem& problem, const Eigen::VectorXd& force,
                      std::span<const Eigen::Vector3d> attachment_motion);

  /// After `linearize`: the contacts as the factorised curvature has them, and whether it takes one to be open.
  const std::vector<ContactPoint>& factorised_contacts() const { return factorised_contacts_; }
  bool is_factorised_open(std::size_t contact) const { return open_[contact]; }

  /// Part of a motion (3 vertices, metres) that leads to no contact of the wall with itself or its floor, and takes no
  /// triangle of a shell through its neighbour.
  double safe_fraction(const Eigen::VectorXd& position, const Eigen::VectorXd& motion);

  /// Force that holds the rigid motions of a free body, (unknowns), newton, at a state that a solve has reached.
  Eigen::VectorXd rigid_force(const EquilibriumState& state) const { return -rigid_columns_ * state.rigid_reaction; }

  /// Terms at the state that the last solve ended with, or that was looked at since.
  const EquilibriumTerms& terms() const { return terms_; }

 private:
  static constexpr double kLeastShift = 1e-6;  // of the wall's stiffness, that makes a matrix convex

  struct Step {
    Eigen::VectorXd position;             // (unknowns), metres
    Eigen::VectorXd pressure;             // (chambers), pascal
    Eigen::VectorXd rigid;                // newton
    Eigen::VectorXd multipliers;          // (border), of which the last two are part
    std::vector<Eigen::Vector3d> forces;  // (attachments), newton, new values
    std::vector<double> contact_forces;   // (contacts), newton, new values; negative where a contact would open
  };
  struct Residual {
    Eigen::VectorXd force;              // (unknowns), newton, zero at fixed unknowns
    Eigen::VectorXd volume;             // (chambers), metres^3, volume minus what the fluid asks
    Eigen::VectorXd rigid;              // (free rigid motions), metres
    std::vector<Eigen::Vector3d> gaps;  // (attachments), metres, material point minus target
    double contact = 0;                 // metres, largest gap by which a contact misses its law
    double ghost = 0;                   // newton, largest force left at a contact that is open
    double opening = 0;                 // metres, by which such contacts are open at most
    double largest_force = 0;           // newton
    double measure = 0;  // newton, of all: displacements by which constraints are missed count with the wall's
                         // stiffness
  };
  /// What a search along a step has found.
  enum class Descent {
    kNone,       // neither less residual nor less energy
    kLower,      // one of them
    kAsForeseen  // the energy fell as the curvature that the step was found with foresaw, or more
  };
  /// How a solution gets on from iteration to iteration.
  struct Progress {
    int calm = 0;               // iterations in a row by which the residual fell
    int inexact = 0;            // iterations in a row whose matrix had to be made convex, or was taken though it is not
    bool takes_saddle = false;  // whether the last one took the matrix as it is
    Descent descent = Descent::kNone;  // of the last search
    int stalled = 0;                   // iterations since the largest force was least
    int kept = 0;                      // iterations in a row that were found with the factor of one before
    int without_gain = 0;              // iterations since the largest force was least of those after the first step
    double last_measure = 0;           // newton
    double force = 0;                  // newton, largest now
    double last_force = 0;             // newton, the same before the last iteration
    double least_force = std::numeric_limits<double>::infinity();    // newton
    double least_stepped = std::numeric_limits<double>::infinity();  // newton, after the first step

    void note(const Residual& residual);
    /// Whether the next step is tried whole; `iterations`: so far.
    bool tries_whole_step(int iterations) const;
    /// Whether steps without line search lead nowhere where flaps are taken.
    bool goes_astray() const;
    /// Whether a step by which the residual falls as it did by the last one, or faster, would be the last one.
    bool foresees_end(const Residual& residual, double tolerance) const;
  };

  /// How the search for the contacts of a step gets on: all that are wrong are changed at once, until that leaves no
  /// fewer wrong, as it may go in circles; then from the beginning one at a time, on a way on which no force ever pulls
  /// and the energy falls (Lawson and Hanson 1974, non-negative least squares).
  struct ContactTurns {
    bool may_be_one_by_one = false;
    bool one_by_one = false;
    int fewest_wrong = std::numeric_limits<int>::max();
    int without_gain = 0;        // turns in a row that left no fewer wrong
    std::vector<double> forces;  // (contacts), newton, of the way
  };

  /// Of the constraints in the merit function, above their multipliers.
  struct Weights {
    double pressure;  // pascal
    double force;     // newton
    double contact;   // newton
  };

  /// Loads that no energy has, as they are where a line search begins.
  struct Frozen {
    Eigen::VectorXd position;   // (unknowns), metres
    Eigen::VectorXd lip_force;  // (unknowns), newton
    Eigen::VectorXd pressure;   // (chambers), pascal, of those that hold air
    Eigen::VectorXd outflow;    // (chambers), metres^3 / pascal, by which more leaks as the pressure rises
    Eigen::VectorXd lip_spill;  // (unknowns), newton, pressure times what leaks more as the lips go apart
  };

  /// Where a step begins.
  struct Start {
    EquilibriumState state;
    std::vector<Attachment> attachments;
    std::vector<SolidContact> solids;
    std::vector<FrictionContact> friction;
  };

  /// What a cut wall takes over from the one before, made side by side.
  struct CarriedParts {
    std::optional<SparseFactor> factor;
    std::optional<SelfContact> self_contact;
  };

  Newton(const BodyModel& model, SparseFactor factor, SelfContact self_contact);
  Newton(const BodyModel& model, CarriedParts parts);
  static CarriedParts carried_parts(const BodyModel& model, const Newton& before, const Eigen::VectorXd& position);
  /// Completes the unknowns and evaluates there; false where the wall is beyond its law.
  bool begin(EquilibriumProblem& problem, EquilibriumState& state, bool with_hessian);
  NewtonResult iterate(EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options,
                       bool foresees);
  /// The same with line search, of a slack wall that is held, which is held more for a while where it has to be.
  NewtonResult iterate_held(EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options);
  /// What is left where `terms_` were found, and gives the scale of the forces there, newton.
  double note_residual(const EquilibriumProblem& problem, const EquilibriumState& state, double tolerance,
                       Residual& residual, NewtonResult& result) const;
  /// Notes where a step ended whose curvature is as good there.
  void note_step(const Step& step, const EquilibriumState& state);
  /// Whether the next step may do with the factor of the last one; `tolerance` and `scale`: newton, of forces.
  bool may_keep_factor(const EquilibriumProblem& problem, const Residual& residual, double tolerance, double scale,
                       const Progress& progress);
  /// Makes the factorised contacts those that are there now; false where one is not that is a spring in the matrix.
  bool find_factorised_contacts();
  static std::vector<std::array<int, 4>> hinges_of(const BodyModel& model);
  bool folds_over(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const;
  void foresee(const EquilibriumProblem& problem, const Eigen::VectorXd& position, const Eigen::VectorXd& motion);
  void add_foreseen(const EquilibriumProblem& problem, const Eigen::VectorXd& position);
  static Start started(const EquilibriumProblem& problem, const EquilibriumState& state);
  static void go_back(const Start& start, EquilibriumProblem& problem, EquilibriumState& state);
  const Start& kept_start(const EquilibriumProblem& problem, const EquilibriumState& state);
  void place(const Start& start, const Step& step, double fraction, EquilibriumProblem& problem,
             EquilibriumState& state);
  bool take_whole(EquilibriumProblem& problem, EquilibriumState& state, Residual& residual, const Step& step);
  void evaluate_all(const EquilibriumProblem& problem, const EquilibriumState& state, bool with_hessian,
                    EquilibriumTerms& terms);
  double contact_force(const EquilibriumProblem& problem, const ContactPoint& contact) const;
  double contact_law(const ContactPoint& contact) const;
  double gap_change(const ContactPoint& contact, const Eigen::VectorXd& motion) const;
  void compute_residual(const EquilibriumProblem& problem, const EquilibriumState& state, const EquilibriumTerms& terms,
                        Residual& residual) const;
  void compute_volume_residual(const EquilibriumProblem& problem, const EquilibriumState& state,
                               const EquilibriumTerms& terms, Residual& residual) const;
  void border_fluids(const EquilibriumProblem& problem, const EquilibriumState& state);
  void border_openings(const EquilibriumProblem& problem, const EquilibriumState& state);
  void clear_fixed(Eigen::VectorXd& forces) const;
  bool is_solved(const EquilibriumProblem& problem, const Residual& residual, double force_scale, bool is_stalled,
                 const NewtonOptions& options) const;
  bool has_converged(const EquilibriumProblem& problem, const Residual& residual, const NewtonResult& result,
                     bool is_stalled, const NewtonOptions& options) const;
  /// Metres, from the origin to the body beyond twice its extent.
  double distance_of(const EquilibriumProblem& problem) const;
  double force_scale(const EquilibriumProblem& problem, const EquilibriumTerms& terms, double tolerance) const;
  /// Newton, in a force of inertia.
  double round_off(const EquilibriumProblem& problem, const EquilibriumTerms& terms) const;
  void build_border(const EquilibriumProblem& problem, const EquilibriumState& state);
  /// Adds the even tension that makes the matrix of an open membrane convex, `shift` of the wall's stiffness.
  void add_tension(double shift);
  void build_matrix(const EquilibriumProblem& problem, const EquilibriumState& state, double shift);
  /// `residual`: of the step that is found next, or none.
  bool factorize(const EquilibriumProblem& problem, const EquilibriumState& state, const Residual* residual,
                 double& shift, bool may_be_saddle);
  /// Whether a matrix, factorised so, is convex with its border or may be no more than a saddle. `expected`: (unknowns)
  /// or none, newton, what the next step is found from.
  bool is_usable(std::span<const double> values, const Eigen::VectorXd& expected, bool may_be_saddle,
                 Precision precision);
  /// Whether the next matrix is tried in single precision first, and the same so: in double where that will not do.
  bool takes_single_precision(const EquilibriumProblem& problem, const Eigen::VectorXd& expected);
  bool is_usable_in_single(std::span<const double> values, const Eigen::VectorXd& expected, bool may_be_saddle);
  SparseFactor& used_factor() { return folded_ ? fold_matrix_.factor() : factor_; }
  /// Finds the step again until no contact of it pulls or is overrun; false where no matrix can be factorised.
  bool find_step_with_contacts(const EquilibriumProblem& problem, const EquilibriumState& state,
                               const Residual& residual, double& shift, bool may_be_saddle, Step& step);
  void find_step(const EquilibriumProblem& problem, const EquilibriumState& state, const Residual& residual,
                 Step& step);
  /// (unknowns), newton, from which a step is taken.
  Eigen::VectorXd force_of_step(const EquilibriumProblem& problem, const EquilibriumState& state,
                                const Residual& residual) const;
  /// The same with what attachments pull whose forces change by `changes` and whose gaps are `missed`'s, or none.
  Eigen::VectorXd with_pulls(const EquilibriumProblem& problem, const Eigen::VectorXd& force, const Residual* missed,
                             const std::vector<Eigen::Vector3d>& changes) const;
  /// What forces at the rims of openings a step adds that the symmetric matrix leaves out, (unknowns), newton; `first`
  /// is the step without them.
  Eigen::VectorXd left_out_at_rims(const EquilibriumProblem& problem, const EquilibriumState& state, const Step& first);
  /// What a force, (unknowns), newton, and the constraints as they are missed (none: not at all) make with the matrix
  /// that was factorised last; the forces at attachments are changes.
  void solve_linear(const EquilibriumProblem& problem, const Eigen::VectorXd& force, const Residual* missed,
                    Step& step);
  /// Refines what that made of all forces that a step was found from, where it was with a factor in single precision.
  void refine_step(const EquilibriumProblem& problem, const Eigen::VectorXd& force, const Residual* missed, Step& step);
  Eigen::VectorXd missed_constraints(const EquilibriumProblem& problem, const Residual* missed) const;
  void set_multipliers(const EquilibriumProblem& problem, Eigen::VectorXd multipliers, Step& step) const;
  void find_contact_forces(Step& step) const;
  bool revise_contacts(const Step& step, ContactTurns& turns);
  bool change_one_contact(const Step& step, ContactTurns& turns);
  /// Whether the bordered matrix is still that of the last factorisation, with contacts open and closed as they are.
  bool is_as_factorised() const;
  /// Borders the factorised matrix with the springs of contacts that are open or closed unlike when it was factorised;
  /// false where that is not convex, or round-off leaves nothing of what the springs give.
  bool border_contacts();
  /// The border solved with the factor; a contact's column is solved once, however often it opens and closes.
  Eigen::MatrixXd solved_border(const std::vector<std::size_t>& changed);
  /// Which branches of their laws lips on needles follow, see NewtonShafts.cpp: as they are, in the matrix and in the
  /// force from which a step is taken, and again after it.
  void begin_shafts(const EquilibriumProblem& problem, const EquilibriumState& state);
  template <typename Visit>
  void visit_changed_shafts(const EquilibriumProblem& problem, const EquilibriumState& state, const Visit& visit) const;
  void add_changed_shafts(const EquilibriumProblem& problem, const EquilibriumState& state);
  Eigen::VectorXd changed_shaft_force(const EquilibriumProblem& problem, const EquilibriumState& state) const;
  bool revise_shafts(const EquilibriumProblem& problem, const EquilibriumState& state, const Step& step);
  bool bears_as_factorised(const EquilibriumProblem& problem) const;
  /// Evaluates with the curvature where a solve has ended, with the contacts that press.
  void evaluate_at_end(const EquilibriumProblem& problem, const EquilibriumState& state);
  Step softest_motion(const EquilibriumProblem& problem);
  /// Goes a part of a step and back to the volumes that the contents fill, by the motion that takes least energy.
  void place_within(const Start& start, Step step, double part, EquilibriumProblem& problem, EquilibriumState& state);
  double lowest_part(const Step& step, double sign, EquilibriumProblem& problem, EquilibriumState& state,
                     double& lowest);
  std::string obstructed(const std::string& reason) const;
  Descent search(EquilibriumProblem& problem, EquilibriumState& state, Residual& residual, const Step& step,
                 double fraction);
  bool may_relax_patches(const EquilibriumProblem& problem, const NewtonOptions& options, int iterations) const;
  /// Solves what is left of a residual in few vertices with the others held, patch by patch, while that helps.
  void relax_patches(const EquilibriumProblem& problem, EquilibriumState& state, const NewtonOptions& options);
  /// False, with all as it was, where there is no patch or the whole gains little. `goal`: newton, of the gradient.
  bool relax_patch(const EquilibriumProblem& problem, EquilibriumState& state, double goal, Residual& residual);
  void freeze(const EquilibriumProblem& problem, const EquilibriumState& state);
  double merit(const EquilibriumProblem& problem, const EquilibriumState& state, const EquilibriumTerms& terms,
               const Residual& residual, const Weights& weights) const;
  double merit_slope(const EquilibriumProblem& problem, const EquilibriumState& state, const Residual& residual,
                     const Step& step, const Weights& weights) const;

  const BodyModel& model_;
  SparseFactor factor_;
  SelfContact self_contact_;
  FoldMatrix fold_matrix_;
  std::vector<int> rims_;  // unknowns at the lips of openings, ascending
  bool is_exact_ = true;   // whether the matrix in use is the curvature as it is
  bool is_convex_ = true;  // whether it is convex with its border
  bool folded_ = false;    // whether the last factorisation is the fold matrix's
  BorderedSystem bordered_;
  EquilibriumTerms terms_;
  Start start_;  // of the step under way; kept, as the next one, for its memory
  EquilibriumTerms trial_terms_;
  Residual trial_residual_;
  Eigen::VectorXd stepped_to_;  // (unknowns) or none, metres, where the last solve ended if with a step
  Frozen frozen_;
  std::vector<char> open_;                         // (contacts), whether the step takes the contact to be open
  std::vector<char> factorised_open_;              // (contacts), the same when the matrix was factorised
  std::vector<ContactPoint> factorised_contacts_;  // as they were then
  std::vector<ShaftBranch> branches_;              // (vertices of lips on shafts), that the step takes them to follow
  std::vector<double> matrix_;                     // (non-zeros), what is factorised
  int factorisations_ = 0;                         // in the solution under way
  int in_single_precision_ = 0;                    // of these
  int doubles_left_ = 0;                           // factorisations until single precision is tried again
  bool shifts_by_tension_ = false;                 // whether a shift is a tension
  bool keeps_shift_ = false;                       // see NewtonOptions::buckles
  bool begins_held_ = false;                       // see NewtonLeastMotion.cpp
  double last_shift_ = 0;                          // by which a matrix was made convex last
  int ascending_steps_ = 0;                        // in the solution under way
  bool keeps_factor_ = false;               // whether the step under way is found with the factor of the one before
  bool may_end_ = false;                    // whether that may be the last step: the Hessian is not asked for then
  bool may_border_ = false;                 // see NewtonOptions::borders_contacts
  bool may_be_one_by_one_ = false;          // see ContactTurns
  std::vector<std::array<int, 4>> hinges_;  // of a shell: vertices of two triangles, as in a Hinge
  // (triangles) of a shell, pascal, (S11, S22, S12); none where the curvature takes the stress as it is
  std::vector<Eigen::Vector3d> foreseen_stress_;
  Eigen::MatrixXd border_;          // (unknowns x border), column and row where they are the same
  Eigen::MatrixXd columns_, rows_;  // (unknowns x border), of bodies with open chambers
  Eigen::MatrixXd corner_;          // (border x border)
  std::vector<int> bordering_;      // chambers whose pressure is a multiplier, in the order of the border's columns
  Eigen::MatrixXd solved_own_;      // (unknowns x own columns and those of `solved_contacts_`), K^-1 border
  std::vector<std::size_t> solved_contacts_;  // since the last factorisation
  int constraints_ = 0;                       // columns of the border that are constraints
  int negative_pivots_ = 0;                   // of the factor in use
  Eigen::Index own_columns_ = 0;              // of the border, without those of contacts
  Eigen::MatrixXd rigid_columns_;             // (unknowns x free rigid motions), relative mass times motion
  double extent_;                             // metres, of the body at rest
  double little_strain_;                      // whose forces are the least that others are held against
  double attachment_stiffness_ = 0;           // newton / metre, gamma
};

}  // namespace thinwall
