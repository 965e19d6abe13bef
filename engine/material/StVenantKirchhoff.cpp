#include <array>

#include "engine/material/CollapseGuard.hpp"
#include "engine/material/WallLawRows.hpp"

namespace thinwall {
namespace {

constexpr std::array<LawParameter, 2> kParameters = {{
    {"youngs_modulus", "Pa", 0, true, 1e13, std::nullopt, "Young's modulus E."},
    {"poisson_ratio", "", -0.99, false, 0.5, std::nullopt,
     "Poisson's ratio nu; 0.5 is incompressible at small strain."},
}};

WallLawResponse respond(std::span<const double> parameters, const Eigen::Vector3d& c) {
  const double nu = parameters[1];
  const double factor = parameters[0] / (1 - nu * nu);
  const Eigen::Vector3d strain(0.5 * (c[0] - 1), 0.5 * (c[1] - 1), c[2]);
  WallLawResponse response;
  response.tangent << factor, factor * nu, 0, factor * nu, factor, 0, 0, 0, factor * 0.5 * (1 - nu);
  response.second_piola_kirchhoff = response.tangent * strain;
  response.energy = 0.5 * strain.dot(response.second_piola_kirchhoff);
  guard_against_collapse(parameters[0], c, response);
  return response;
}

double initial_modulus(std::span<const double> parameters) {
  return parameters[0];
}

}  // namespace

const WallLaw kStVenantKirchhoff = {
    .name = "st_venant_kirchhoff",
    .formula =
        "W = E/(2 (1 - nu^2)) (E11^2 + E22^2 + 2 nu E11 E22 + 2 (1 - nu) E12^2), "
        "and E/10 ln(1/(2 det C))^3 where det C < 1/2",
    .source =
        "Plane stress of a linear law in the Green-Lagrange strain; for small strain: by itself it softens in "
        "compression, and a strip of it loses all its width when it is drawn out, which the last term prevents",
    .parameters = kParameters,
    .respond = respond,
    .initial_modulus = initial_modulus,
};

}  // namespace thinwall
