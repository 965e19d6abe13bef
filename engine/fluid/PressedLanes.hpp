#pragma once

#include "engine/fluid/PressureLoad.hpp"
#include "engine/solver/Lanes.hpp"

namespace thinwall {

/// A pressure field for each of kLanes triangles.
struct PressureLanes {
  double at_origin[kLanes] = {};  // pascal
  double slope[3][kLanes] = {};   // pascal / metre
  bool suction[kLanes] = {};

  void set(int lane, const PressureField& field) {
    at_origin[lane] = field.at_origin;
    for (int k = 0; k < 3; ++k) slope[k][lane] = field.slope[k];
    suction[lane] = field.suction;
  }
};

/// What pressures do to kLanes triangles side by side, equal to the bit to what PressedTriangle says of each.
struct PressedLanes {
  double load[9][kLanes];          // newton
  double unit_load[9][kLanes];     // metres^2
  double stiffness[6][9][kLanes];  // newton / metre, minus the symmetric tangent: the blocks of kBlockCorners by
                                   // columns, of those on the diagonal the lower triangle
};

/// `corners`: (9 x lanes), metres, x0, y0, z0, x1, ..., z2. Without `with_stiffness` that is left as it was.
void pressed_lanes(const double (&corners)[9][kLanes], const PressureLanes& field, bool with_stiffness,
                   PressedLanes& terms);

/// Adds loads and stiffness of further pressures on the same triangles; the unit load stays that of the first.
void add_to(PressedLanes& terms, const PressedLanes& further, bool with_stiffness);

/// The same for `moment_loads_of`. `loads`: (axes x 9 x lanes), newton.
void moment_loads_of(const double (&corners)[9][kLanes], double (&loads)[3][9][kLanes]);

}  // namespace thinwall
