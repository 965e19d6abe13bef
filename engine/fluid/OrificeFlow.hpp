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

inline constexpr double kLaminarPressure = 0.1;  // pascal

}  // namespace thinwall
