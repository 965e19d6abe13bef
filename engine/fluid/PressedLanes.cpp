#include "engine/fluid/PressedLanes.hpp"

#include <algorithm>

#include "engine/solver/BlockPattern.hpp"

namespace thinwall {
namespace {

/// Lanes of what PressedTriangle has of one triangle.
struct Pressed {
  Lanes normal[3];
  Lanes edges[9];
  Lanes slope[3];
  Lanes pressures[3];
  Lanes moments[3][3];
  Lanes shares[3];
};

[[gnu::always_inline]] inline void find_normal(const Lanes (&at)[9], Lanes (&normal)[3]) {
  Lanes one[3], two[3];
  for (int k = 0; k < 3; ++k) {
    one[k] = at[3 + k] - at[k];
    two[k] = at[6 + k] - at[k];
  }
  cross(one, two, normal);
}

THINWALL_FOR_ALL_PROCESSORS void find_pressures(const double (&corners)[9][kLanes], const PressureLanes& field,
                                                Pressed& pressed) {
  Lanes at[9], at_origin;
  for (int k = 0; k < 9; ++k) load(corners[k], at[k]);
  for (int k = 0; k < 3; ++k) load(field.slope[k], pressed.slope[k]);
  load(field.at_origin, at_origin);
  find_normal(at, pressed.normal);
  for (int corner = 0; corner < 3; ++corner) {
    const Lanes *next = at + 3 * ((corner + 1) % 3), *last = at + 3 * ((corner + 2) % 3);
    for (int k = 0; k < 3; ++k) pressed.edges[3 * corner + k] = last[k] - next[k];
    const Lanes *slope = pressed.slope, *place = at + 3 * corner;
    pressed.pressures[corner] = at_origin + (slope[0] * place[0] + slope[1] * place[1] + slope[2] * place[2]);
  }
}

/// Few triangles lie across a free surface: what is cut off there is found one by one.
void find_moments(const PressureLanes& field, Pressed& pressed) {
  const Eigen::Matrix3d whole = pressed_moments(Eigen::Vector3d::Zero(), true);
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) pressed.moments[a][b] = Lanes{} + whole(a, b);
  }
  for (int lane = 0; lane < kLanes; ++lane) {
    if (field.suction[lane]) continue;
    const Eigen::Vector3d pressures(pressed.pressures[0][lane], pressed.pressures[1][lane], pressed.pressures[2][lane]);
    const Eigen::Matrix3d moments = pressed_moments(pressures, false);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) pressed.moments[a][b][lane] = moments(a, b);
    }
  }
}

THINWALL_FOR_ALL_PROCESSORS void find_loads(Pressed& pressed, PressedLanes& terms) {
  for (int a = 0; a < 3; ++a) {
    const Lanes *moments = pressed.moments[a], *pressures = pressed.pressures;
    const Lanes parts[3] = {moments[0] * pressures[0], moments[1] * pressures[1], moments[2] * pressures[2]};
    // Summed as Eigen sums them, which takes two rows at once and the last by itself.
    pressed.shares[a] = a < 2 ? parts[0] + parts[1] + parts[2] : parts[0] + (parts[1] + parts[2]);
    const Lanes whole = moments[0] + (moments[1] + moments[2]);
    for (int k = 0; k < 3; ++k) {
      store(pressed.shares[a] * pressed.normal[k], terms.load[3 * a + k]);
      store(whole * pressed.normal[k], terms.unit_load[3 * a + k]);
    }
  }
}

THINWALL_FOR_ALL_PROCESSORS void find_stiffness(const Pressed& pressed, PressedLanes& terms) {
  Lanes tilt[9];
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      tilt[3 * column + row] =
          0.5 * (pressed.normal[row] * pressed.slope[column] + pressed.slope[row] * pressed.normal[column]);
    }
  }
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k) {
    const int a = kBlockCorners[k][0], b = kBlockCorners[k][1];
    Lanes block[9];
    for (int entry = 0; entry < 9; ++entry) block[entry] = pressed.moments[a][b] * tilt[entry];
    for (int column = 0; column < 3 && a != b; ++column) {
      // Column by column of the matrix of a cross product.
      const int next = (column + 1) % 3, last = (column + 2) % 3;
      const Lanes* edges = pressed.edges;
      block[3 * column + next] +=
          0.5 * (pressed.shares[a] * edges[3 * b + last] - pressed.shares[b] * edges[3 * a + last]);
      block[3 * column + last] -=
          0.5 * (pressed.shares[a] * edges[3 * b + next] - pressed.shares[b] * edges[3 * a + next]);
    }
    for (int entry = 0; entry < 9; ++entry) store(-block[entry], terms.stiffness[k][entry]);
  }
}

}  // namespace

void pressed_lanes(const double (&corners)[9][kLanes], const PressureLanes& field, bool with_stiffness,
                   PressedLanes& terms) {
  Pressed pressed;
  find_pressures(corners, field, pressed);
  find_moments(field, pressed);
  find_loads(pressed, terms);
  if (with_stiffness) find_stiffness(pressed, terms);
}

void add_to(PressedLanes& terms, const PressedLanes& further, bool with_stiffness) {
  for (int k = 0; k < 9; ++k) {
    for (int lane = 0; lane < kLanes; ++lane) terms.load[k][lane] += further.load[k][lane];
  }
  for (int block = 0; block < 6 && with_stiffness; ++block) {
    for (int k = 0; k < 9; ++k) {
      for (int lane = 0; lane < kLanes; ++lane) terms.stiffness[block][k][lane] += further.stiffness[block][k][lane];
    }
  }
}

THINWALL_FOR_ALL_PROCESSORS void moment_loads_of(const double (&corners)[9][kLanes], double (&loads)[3][9][kLanes]) {
  Lanes at[9], normal[3];
  for (int k = 0; k < 9; ++k) load(corners[k], at[k]);
  find_normal(at, normal);
  for (int axis = 0; axis < 3; ++axis) {
    const Lanes sum = at[axis] + at[3 + axis] + at[6 + axis];
    for (int a = 0; a < 3; ++a) {
      const Lanes shares = (at[3 * a + axis] + sum) / 24;
      for (int k = 0; k < 3; ++k) store(shares * normal[k], loads[axis][3 * a + k]);
    }
  }
}

}  // namespace thinwall
