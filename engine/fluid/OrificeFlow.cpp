#include "engine/fluid/OrificeFlow.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {

Flow orifice_flow(double coefficient, double area, double density, double pressure) {
  const double scale = coefficient * area * std::sqrt(2 / density);
  const double square = pressure * pressure + kLaminarPressure * kLaminarPressure;
  const double root = std::sqrt(std::sqrt(square));
  return {.rate = scale * pressure / root, .slope = scale / root * (1 - 0.5 * pressure * pressure / square)};
}

Flow approached_orifice_flow(double coefficient, double area, double density, double pressure, double approach) {
  if (approach <= 0) return orifice_flow(coefficient, area, density, pressure);
  const Flow even = orifice_flow(1, 1, density, pressure);  // metres / second, of the whole fall of pressure
  const double speed = std::hypot(approach, even.rate), contraction = std::min(coefficient, 0.5);
  const double free = coefficient * speed - approach, balanced = contraction * (speed - approach);
  const double part = free > balanced ? coefficient : contraction;
  return {.rate = area * (approach + std::copysign(std::max(free, balanced), pressure)),
          .slope = area * part * std::abs(even.rate) / speed * even.slope};
}

}  // namespace thinwall
