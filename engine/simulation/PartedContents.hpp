#pragma once

#include "engine/cutting/Cut.hpp"
#include "engine/simulation/Body.hpp"

namespace thinwall {

/// Which parts of a wall hold contents after a cut. The parts that a chamber's wall has come apart into are those that
/// share its triangles. The one that encloses most at rest keeps the chamber, its place among the chambers and its
/// name. Another holds contents of its own, in a new chamber that follows the others, when it is a bowl: when its wall
/// and caps are at least one and a half times as large as its openings, as a cap of a ball from 71 degrees on. A
/// flatter part is a piece of wall without contents. All borders of parts with contents are openings.
struct PartedContents {
  std::vector<Opening> openings;
  std::vector<ChamberDefinition> chambers;  // all, each told by a triangle of its wall
};

/// `mesh`: of the surface after `cut`, whose wall had contents, and was closed but for its caps before the first cut.
PartedContents parted_contents(const BodyModel& before, const SurfaceMesh& mesh, const Cut& cut);

/// Brings the contents of a state to a cut body; `carried` has its positions already. Fluid goes with the volume below
/// the surface that it has, and keeps its pressure. What has leaked stays with the chamber that keeps its place. What
/// no longer finds room, because an opening spans the chamber lower than the wall did, has leaked. The fluid's motion
/// stays the same everywhere. Contents that do not run out keep their volume, also where other caps span the lips.
/// `gravity`: metres / second^2.
void carry_contents(const BodyModel& before, const BodyState& state, const BodyModel& after, const Cut& cut,
                    const Eigen::Vector3d& gravity, BodyState& carried);

}  // namespace thinwall
