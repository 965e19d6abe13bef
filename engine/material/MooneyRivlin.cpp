#include <array>

#include "engine/material/IsotropicResponse.hpp"
#include "engine/material/WallLawRows.hpp"

namespace thinwall {
namespace {

constexpr std::array<LawParameter, 2> kParameters = {{
    {"c1", "Pa", 0, true, 1e12, std::nullopt, "Factor of the first invariant; the shear modulus is 2 (c1 + c2)."},
    {"c2", "Pa", 0, false, 1e12, std::nullopt, "Factor of the second invariant."},
}};

WallLawResponse respond(std::span<const double> parameters, const Eigen::Vector3d& c) {
  const double c1 = parameters[0], c2 = parameters[1];
  const double trace = c[0] + c[1];
  const double d = c[0] * c[1] - c[2] * c[2];
  return isotropic_response({.energy = c1 * (trace + 1 / d - 3) + c2 * (d + trace / d - 3),
                             .by_trace = c1 + c2 / d,
                             .by_det = -c1 / (d * d) + c2 * (1 - trace / (d * d)),
                             .trace_det = -c2 / (d * d),
                             .det_det = 2 * (c1 + c2 * trace) / (d * d * d)},
                            c);
}

double initial_modulus(std::span<const double> parameters) {
  return 6 * (parameters[0] + parameters[1]);
}

}  // namespace

const WallLaw kMooneyRivlin = {
    .name = "mooney_rivlin",
    .formula = "W = c1 (tr C + 1/det C - 3) + c2 (det C + tr C/det C - 3)",
    .source = "Mooney 1940, Rivlin 1948; incompressible plane stress, stretch across the wall squared = 1/det C",
    .parameters = kParameters,
    .respond = respond,
    .initial_modulus = initial_modulus,
};

}  // namespace thinwall
