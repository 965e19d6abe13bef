#include "engine/fluid/OrificeFlow.hpp"

#include <cmath>

namespace thinwall {

Flow orifice_flow(double coefficient, double area, double density, double pressure) {
  const double scale = coefficient * area * std::sqrt(2 / density);
  const double square = pressure * pressure + kLaminarPressure * kLaminarPressure;
  const double root = std::sqrt(std::sqrt(square));
  return {.rate = scale * pressure / root, .slope = scale / root * (1 - 0.5 * pressure * pressure / square)};
}

}  // namespace thinwall
