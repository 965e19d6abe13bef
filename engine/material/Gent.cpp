#include <array>
#include <cmath>

#include "engine/material/IsotropicResponse.hpp"
#include "engine/material/WallLawRows.hpp"

namespace thinwall {
namespace {

constexpr std::array<LawParameter, 2> kParameters = {{
    {"shear_modulus", "Pa", 0, true, 1e12, std::nullopt, "Shear modulus mu at small strain; Young's modulus is 3 mu."},
    {"limit", "", 0, true, 1e6, std::nullopt, "Value Jm of I1 - 3 at which the wall cannot be stretched any further."},
}};

WallLawResponse respond(std::span<const double> parameters, const Eigen::Vector3d& c) {
  const double mu = parameters[0], limit = parameters[1];
  const double d = c[0] * c[1] - c[2] * c[2];
  const double spent = (c[0] + c[1] + 1 / d - 3) / limit;
  if (!(spent < 1)) return beyond_the_law();
  const double slope = 0.5 * mu / (1 - spent);             // dW/dI1 of the invariant in space
  const double curvature = slope / (limit * (1 - spent));  // its second derivative
  const double by_det = -1 / (d * d);                      // dI1/d(det C)
  return isotropic_response({.energy = -0.5 * mu * limit * std::log1p(-spent),
                             .by_trace = slope,
                             .by_det = slope * by_det,
                             .trace_det = curvature * by_det,
                             .det_det = curvature * by_det * by_det + 2 * slope / (d * d * d),
                             .trace_trace = curvature},
                            c);
}

double initial_modulus(std::span<const double> parameters) {
  return 3 * parameters[0];
}

}  // namespace

const WallLaw kGent = {
    .name = "gent",
    .formula = "W = -mu Jm/2 ln(1 - (I1 - 3)/Jm), I1 = tr C + 1/det C",
    .source = "Gent 1996; incompressible plane stress; stiffens without bound where I1 - 3 nears Jm",
    .parameters = kParameters,
    .respond = respond,
    .initial_modulus = initial_modulus,
};

}  // namespace thinwall
