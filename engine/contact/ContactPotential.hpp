#pragma once

#include <algorithm>

namespace thinwall {

/// The potential that keeps a site of a wall out of a tool, as a function of the gap between the two: the force rises
/// evenly below the gap at which it sets in. An even rise makes a contact a linear spring, so that Newton's method only
/// has to find out what touches.
struct ContactPotential {
  double onset = 1e-6;   // metres, the gap below which it pushes
  double stiffness = 1;  // newton / metre

  /// Newton; negative beyond the onset, where a spring would pull.
  double spring_force(double gap) const { return stiffness * (onset - gap); }
  /// Joule.
  double energy(double gap) const {
    const double closed = std::max(0.0, onset - gap);
    return 0.5 * stiffness * closed * closed;
  }
};

}  // namespace thinwall
