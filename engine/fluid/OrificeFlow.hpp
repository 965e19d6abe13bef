#pragma once

namespace thinwall {

/// Flow through a hole and its slope.
struct Flow {
  double rate = 0;   // metres^3 / second, along the fall of pressure
  double slope = 0;  // metres^3 / second / pascal
};

/// Orifice flow Q = coefficient area sqrt(2 p / density) for a fall of pressure p, metres^2, kg / metre^3 and pascal
/// (Bernoulli with a discharge coefficient). Below about kLaminarPressure it turns linear in p, as slow flow does; the
/// root alone has no slope at zero. There, Q = coefficient area sqrt(2 / density) p / (p^2 + kLaminarPressure^2)^(1/4).
Flow orifice_flow(double coefficient, double area, double density, double pressure);

/// The same for a hole that fluid comes to with a speed of its own, metres / second, seen from the hole: at the least
/// it goes through as it comes. It leaves at v = (approach^2 + 2 p / density)^(1/2), through a jet of coefficient area,
/// or of as much more as the balance of momentum asks (Borda), Q = area (approach + c (v - approach)) with c the
/// coefficient or 1/2, whichever is less. So the energy that the jet has, also one that leaves lips that draw back, is
/// never less than none where the coefficient is at least 1/2. Without approach it is orifice_flow.
Flow approached_orifice_flow(double coefficient, double area, double density, double pressure, double approach);

inline constexpr double kLaminarPressure = 0.1;  // pascal

}  // namespace thinwall
