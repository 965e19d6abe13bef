#include <array>
#include <cmath>

#include "engine/material/CollapseGuard.hpp"
#include "engine/material/IsotropicResponse.hpp"
#include "engine/material/WallLawRows.hpp"

namespace thinwall {
namespace {

constexpr std::array<LawParameter, 5> kParameters = {{
    {"c", "Pa", 0, true, 1e12, std::nullopt, "Factor of the energy; the modulus along the fibres is about c a1."},
    {"a1", "", 0, true, 1e6, std::nullopt, "Stiffening along the fibres."},
    {"a2", "", 0, true, 1e6, std::nullopt, "Stiffening across them."},
    {"a3", "", -1e6, false, 1e6, std::nullopt, "Coupling of both; its square is below a1 a2."},
    {"a4", "", 0, true, 1e6, std::nullopt, "Stiffening in shear; a1 + a2 - 2 a3 for the same in every direction."},
}};

double initial_modulus(std::span<const double> p) {
  return p[0] * (p[1] - p[3] * p[3] / p[2]);
}

WallLawResponse respond(std::span<const double> p, const Eigen::Vector3d& c) {
  const Eigen::Vector3d strain(0.5 * (c[0] - 1), 0.5 * (c[1] - 1), c[2]);  // (E11, E22, 2 E12)
  Eigen::Matrix3d form;                                                    // Q = e . form e
  form << p[1], p[3], 0, p[3], p[2], 0, 0, 0, 0.25 * p[4];
  const Eigen::Vector3d slope = 2 * form * strain;
  const double exponent = 0.5 * strain.dot(slope);
  const double factor = 0.5 * p[0] * std::exp(exponent);
  WallLawResponse response;
  response.energy = 0.5 * p[0] * std::expm1(exponent);
  response.second_piola_kirchhoff = factor * slope;
  response.tangent = factor * (2 * form + slope * slope.transpose());
  if (!response.tangent.allFinite()) return beyond_the_law();
  guard_against_collapse(initial_modulus(p), c, response);
  return response;
}

std::string complaint(std::span<const double> p) {
  if (p[3] * p[3] < p[1] * p[2]) return "";
  return "the energy falls with some strains: choose a3 with a square below a1 a2";
}

}  // namespace

const WallLaw kFung = {
    .name = "fung",
    .formula =
        "W = c/2 (exp(a1 E11^2 + a2 E22^2 + 2 a3 E11 E22 + a4 E12^2) - 1), and "
        "c (a1 - a3^2/a2)/10 ln(1/(2 det C))^3 where det C < 1/2",
    .source =
        "Fung, Fronek and Patitucci 1979; Tong and Fung 1976; axis 1 along `fibres`; the last term keeps a wall "
        "that is pressed from shrinking to nothing",
    .parameters = kParameters,
    .has_fibres = true,
    .respond = respond,
    .initial_modulus = initial_modulus,
    .complaint = complaint,
};

}  // namespace thinwall
