#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "engine/cutting/Cut.hpp"
#include "engine/mesh/SurfacePoint.hpp"

namespace thinwall {

/// A blade on its way through the wall during a step.
struct BladeInput {
  int tool = 0;                                          // index
  double travel = 0;                                     // metres along its path
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  // unit, of its path
};

/// A force that held a vertex where it was when the wall was cut.
struct HeldForce {
  int vertex = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // newton
};

/// The same of the turn of a shell's edge.
struct HeldTurn {
  int unknown = 0;   // index
  double force = 0;  // newton
};

/// What a cut opens that was made at once.
struct HeldLips {
  std::vector<HeldForce> forces;  // at the lips, and where the changed mesh alone would not rest
  std::vector<HeldTurn> turns = {};
  double held = 1;    // part of the forces that still acts
  double length = 0;  // metres, rest, of the cut: the blade's way over which it is let go
  double worth = 0;   // joule, of new cut area of that length
  bool pays = true;   // whether what it releases pays for new cut area, or is lost
  double work = 0;    // joule, that the forces have done on the wall so far: below zero while they hold it
  bool runs = false;  // let go in a few steps, whatever the blade does: the cut ran ahead here
  // Whether they drive the wall: let go in one step, and by as much as the part where one is divided.
  bool drives = false;
};

/// A gap of the wall that a blade crosses.
struct GapBeyond {
  SurfacePoint lip;                                // where it comes back into the wall
  Eigen::Vector3d way = Eigen::Vector3d::UnitX();  // unit, of the blade
};

/// A cut that is being made. The mesh is cut some way at a time, the blade goes on evenly: so the lips of what was just
/// cut are first held together by the forces that the wall bore there, and let go in step with the blade, as those of a
/// crack that grows by an element (Malluck and King 1980). What these forces take up while the lips open is the elastic
/// energy that the wall releases; what the new area costs beyond it the blade pays, and feels as resistance.
///
/// A sharp blade parts the wall and does not drag it along: the wall around feels the lips alone. To let it bear the
/// resistance as well would take away its tension before the tip, and beside a free lip it has none to give. So what
/// holds the body does not feel the resistance.
///
/// Where the wall alone releases more than the cost the cut runs ahead (see Body::run_ahead). Its lips are let go in
/// some steps, and the blade cuts nothing and feels nothing until it is where the cut has run to.
struct CutProgress {
  std::optional<int> tool = {};            // whose blade is in the wall: the wall is free on it
  std::optional<SurfacePoint> start = {};  // where a blade met the wall, until it is cut there
  std::optional<int> tip = {};             // vertex where the cut goes on
  std::optional<GapBeyond> gap = {};       // that the blade is in
  bool is_in_wound = false;                // whether the blade goes back in its own wound, in which it cuts nothing
  bool is_off_wall = false;                // whether it has no wall before it, as where that gives way from under it
  std::vector<HeldLips> held = {};         // in the order of the cuts: lips that are not free yet
  double cost = 0;                         // newton: of new cut area per length, as it is stretched now, at the tip
  double resistance = 0;                   // newton
  double push = 0;                         // newton, of the blade along its way
  double progress = 0;                     // part of the blade's last way by which it cut; the wall came along the rest
  double given = 0;                        // newton: what the wall releases per length, mean over a triangle
  double owed = 0;                         // joule, of the area on the blade's way so far, that nobody has paid or will
  double due = 0;                          // joule, that what has been cut is worth beyond what has been booked for it
  double length = 0;                       // metres, rest, cut since time zero
  double ahead = 0;                        // metres of the blade's way, in its own wound, to where the cut has run to
  double awaited = 0;                      // metres of the blade's way before it is asked again whether the cut runs
  double run = 0;                          // metres, as it is stretched, that the cut has run in this step
  double run_length = 0;                   // metres, rest, of `length`: that ran ahead of blades
  double division = 1;        // of the step under way: lips that no blade leads lose as much less of theirs
  bool has_incised = false;   // whether a blade has cut the wall, that holds flaps together no more
  bool has_crumpled = false;  // whether one has pressed it along itself: it wrinkles as cut ones do

  /// Whether there is wall before the blade, and it is not in a gap or beyond a border.
  bool is_in_wall() const { return tip || start; }
};

/// After a step: lips let go one after the other over what the blade cuts, taken to be the same part of its way as in
/// the step before, or all by a fixed part where no blade goes on, as are those of cuts that ran ahead: by less where
/// the step is divided. `blade`: none in a gap of the wall.
CutProgress let_go(const CutProgress& progress, const std::optional<BladeInput>& blade);

/// Adds up what the forces at held lips have done on the wall by a motion, (unknowns), metres. They stand for what the
/// wall bore across the cut, and hold lips back: where they do more on the wall than a part of what new area costs they
/// drive it, as a flap that turns or flies away.
void note_work(const Eigen::VectorXd& motion, CutProgress& cut);

/// Marks the lips in `before` that have come to drive the wall in the step to `after`; whether there are any.
bool mark_driving(const CutProgress& after, CutProgress& before);

/// Forces at the lips, (unknowns), newton; none where there are none.
Eigen::VectorXd force_at_lips(const CutProgress& progress, Eigen::Index unknowns);

/// What of the cut area neither is paid for nor will be by lips that are still held, joule.
double unpaid(const CutProgress& cut);

/// Along the left lips, metres. `position`: (unknowns), metres.
double length_of(std::span<const Lips> cut, const Eigen::VectorXd& position);

}  // namespace thinwall
