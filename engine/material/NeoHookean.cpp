#include <array>

#include "engine/material/IsotropicResponse.hpp"
#include "engine/material/WallLawRows.hpp"

namespace thinwall {
namespace {

constexpr std::array<LawParameter, 1> kParameters = {{
    {"shear_modulus", "Pa", 0, true, 1e12, std::nullopt, "Shear modulus mu at small strain; Young's modulus is 3 mu."},
}};

WallLawResponse respond(std::span<const double> parameters, const Eigen::Vector3d& c) {
  const double mu = parameters[0];
  const double d = c[0] * c[1] - c[2] * c[2];
  return isotropic_response({.energy = 0.5 * mu * (c[0] + c[1] + 1 / d - 3),
                             .by_trace = 0.5 * mu,
                             .by_det = -0.5 * mu / (d * d),
                             .trace_det = 0,
                             .det_det = mu / (d * d * d)},
                            c);
}

double initial_modulus(std::span<const double> parameters) {
  return 3 * parameters[0];
}

}  // namespace

const WallLaw kNeoHookean = {
    .name = "neo_hookean",
    .formula = "W = mu/2 (tr C + 1/det C - 3)",
    .source = "Treloar 1943; incompressible plane stress, stretch across the wall squared = 1/det C",
    .parameters = kParameters,
    .respond = respond,
    .initial_modulus = initial_modulus,
};

}  // namespace thinwall
