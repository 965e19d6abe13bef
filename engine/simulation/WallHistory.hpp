#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/equilibrium/BodyModel.hpp"
#include "engine/equilibrium/Equilibrium.hpp"

namespace thinwall {

/// What a viscous wall remembers of the steps before; empty for any other.
struct WallHistory {
  std::vector<Eigen::Vector3d> law_stress;                  // (triangles), pascal, (S11, S22, S12)
  std::vector<std::vector<Eigen::Vector3d>> branch_stress;  // (Prony terms x triangles), pascal
  std::vector<Eigen::Vector3d> overstress;                  // (triangles), pascal: all that is not the lasting stress
  std::vector<Eigen::Vector3d> law_moment;                  // (triangles) of a shell, newton
  std::vector<std::vector<Eigen::Vector3d>> branch_moment;  // (Prony terms x triangles) of a shell, newton
  std::vector<Eigen::Vector3d> overmoment;                  // (triangles) of a shell, newton
  std::vector<Eigen::Vector3d> bending_strain;              // (triangles) of a shell, 1 / metre
  std::vector<Eigen::Vector3d> previous_bending_strain;     // (triangles) of a shell, a step earlier
  std::vector<Eigen::Vector3d> strain;                      // (triangles), (E11, E22, 2 E12)
  std::vector<Eigen::Vector3d> previous_strain;             // (triangles), a step earlier
};

// In all that follows `position`: (unknowns), metres.

/// Part of the law's stress that a viscous wall keeps for good.
double lasting_part(const BodyDefinition& definition);

/// That of a wall which has rested there for long.
WallHistory rested_history(const BodyModel& model, const Eigen::VectorXd& position);

/// Finds strains, and what the laws of wall and bending answer to them, anew: for a mesh that has changed.
void find_strains(const BodyModel& model, const Eigen::VectorXd& position, WallHistory& history);

/// What damping bears now is gone, as at rest.
void stop_damping(const BodyModel& model, WallHistory& history);

/// A step that a wall remembers.
struct HistoryStep {
  double duration = 0;    // seconds
  double previous = 0;    // seconds, of the step before; zero where there is none
  bool is_damped = true;  // whether stiffness_time damps the wall in it
};

/// What the wall bears at the end of a step beside what its laws answer, by the exact recursion of Prony terms (Taylor,
/// Pister and Goudreau 1970) and the second-order backward difference of damping.
WallMemory memory_after(const BodyModel& model, const WallHistory& history, const HistoryStep& step);

/// Brings the history to the end of a step, in seconds, at which the wall has been found at `position` with that
/// memory. What viscosity and damping have spent meanwhile, joule, by the trapezoidal rule.
double remember(const BodyModel& model, const Eigen::VectorXd& position, double duration, const WallMemory& memory,
                WallHistory& history);

/// Principal Cauchy stresses in the middle plane of the wall, (2 x triangles), pascal, the larger first: what the
/// wall bears now, with what viscosity adds. Of a shell the part of the membrane, without that of bending.
Eigen::Matrix2Xd principal_stress(const BodyModel& model, const Eigen::VectorXd& position, const WallHistory& history);

}  // namespace thinwall
