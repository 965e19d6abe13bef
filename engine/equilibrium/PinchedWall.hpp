#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/contact/ContactPotential.hpp"
#include "engine/contact/SolidGap.hpp"
#include "engine/contact/ToolSolid.hpp"
#include "engine/equilibrium/BodyModel.hpp"

namespace thinwall {

/// A vertex of the wall that is pinched: two jaws leave it less room than the wall there is thick.
struct PinchedSite {
  int site = 0;                // index into the model's sites
  ContactPotential potential;  // between the jaw and the middle plane: half of the wall, squeezed
};

/// The pinched vertices of a wall, each list in the order of the sites, with what stands between them and one jaw or
/// the other.
struct PinchedWall {
  std::vector<PinchedSite> one, other;
};

/// Those that lie between the plane parts of both inner sides. A wall of no thickness would slip out from between jaws
/// that it does not fill; as thick as it is, h = rest volume over area now, each half of it yields across as it does
/// along itself: with E Young's modulus, a the area of the vertex, and d the distance of the middle plane from the jaw,
/// the force is a E (1 - 2 d / h). Jaws that have just met the wall squeeze it where it is; by the time that they leave
/// it three quarters of h they have brought it to the middle. So both bear from the first, and neither has to be found.
/// `position`: (unknowns), metres.
PinchedWall pinched_wall(const BodyModel& model, const Eigen::VectorXd& position, const ToolSolid& one,
                         const ToolSolid& other);

/// The side of a jaw that looks at the other one: 1 along its x', -1 against it.
double inner_side(const ToolSolid& jaw, const ToolSolid& other);

/// The gap between corner `corner` of a triangle and the plane of a jaw's inner side, which pushes straight across:
/// what is squeezed is not driven out along itself, as round edges would.
SolidGap gap_from_inner_side(const ToolSolid& jaw, double side, const std::array<Eigen::Vector3d, 3>& corners,
                             int corner);

}  // namespace thinwall
