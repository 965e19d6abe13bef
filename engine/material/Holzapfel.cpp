#include <array>
#include <cmath>
#include <numbers>

#include "engine/material/IsotropicResponse.hpp"
#include "engine/material/WallLawRows.hpp"

namespace thinwall {
namespace {

constexpr std::array<LawParameter, 5> kParameters = {{
    {"shear_modulus", "Pa", 0, true, 1e12, std::nullopt, "Shear modulus mu of the matter between the fibres."},
    {"k1", "Pa", 0, false, 1e12, std::nullopt, "Stiffness of each family of fibres."},
    {"k2", "", 0, true, 1e6, std::nullopt, "How fast the fibres stiffen."},
    {"dispersion", "", 0, false, 1.0 / 3, 0, "Scatter kappa of their directions: 0 none, 1/3 the same in all."},
    {"angle", "rad", 0, false, 0.5 * std::numbers::pi, std::nullopt,
     "Angle of both families to the direction of `fibres`, one to either side."},
}};

/// Adds k1/(2 k2) (exp(k2 E^2) - 1) of a family with the direction (first, second) and
/// E = kappa (I1 - 3) + (1 - 3 kappa) (I4 - 1), where E is not below zero. At zero strain the fibres count as taut.
void add_family(std::span<const double> p, double first, double second, const Eigen::Vector3d& c,
                WallLawResponse& response) {
  const double k1 = p[1], k2 = p[2], kappa = p[3];
  const double d = c[0] * c[1] - c[2] * c[2];
  const Eigen::Vector3d cofactor(c[1], c[0], -c[2]);
  Eigen::Matrix3d cofactor_derivative;
  cofactor_derivative << 0, 2, 0, 2, 0, 0, 0, 0, -1;
  const Eigen::Vector3d direction(first * first, second * second, first * second);  // dI4/de / 2
  const double squared_stretch = c[0] * direction[0] + c[1] * direction[1] + 2 * c[2] * direction[2];
  const double mean = kappa * (c[0] + c[1] + 1 / d - 3) + (1 - 3 * kappa) * (squared_stretch - 1);
  if (mean < 0) return;
  const Eigen::Vector3d by_strain =
      2 * kappa * (Eigen::Vector3d(1, 1, 0) - cofactor / (d * d)) + 2 * (1 - 3 * kappa) * direction;
  const Eigen::Matrix3d second_by_strain =
      kappa * (8 / (d * d * d) * cofactor * cofactor.transpose() - 2 / (d * d) * cofactor_derivative);
  const double growth = k1 * std::exp(k2 * mean * mean);
  response.energy += 0.5 * k1 / k2 * std::expm1(k2 * mean * mean);
  response.second_piola_kirchhoff += growth * mean * by_strain;
  response.tangent +=
      growth * (1 + 2 * k2 * mean * mean) * by_strain * by_strain.transpose() + growth * mean * second_by_strain;
}

WallLawResponse respond(std::span<const double> p, const Eigen::Vector3d& c) {
  WallLawResponse response = kNeoHookean.respond(p.first(1), c);
  if (p[1] > 0) {
    const double along = std::cos(p[4]), across = std::sin(p[4]);
    add_family(p, along, across, c, response);
    add_family(p, along, -across, c, response);
  }
  if (!response.tangent.allFinite() || !std::isfinite(response.energy)) return beyond_the_law();
  return response;
}

double initial_modulus(std::span<const double> parameters) {
  const Eigen::Matrix3d tangent = respond(parameters, Eigen::Vector3d(1, 1, 0)).tangent;
  return tangent(0, 0) - tangent(0, 1) * tangent(0, 1) / tangent(1, 1);
}

}  // namespace

const WallLaw kHolzapfel = {
    .name = "holzapfel",
    .formula =
        "W = mu/2 (I1 - 3) + sum over both families of k1/(2 k2) (exp(k2 <E>^2) - 1), "
        "E = kappa (I1 - 3) + (1 - 3 kappa) (I4 - 1), I1 = tr C + 1/det C",
    .source =
        "Gasser, Ogden and Holzapfel 2006; incompressible plane stress; fibres at +-angle to `fibres`, in tension "
        "only (E > 0)",
    .parameters = kParameters,
    .has_fibres = true,
    .respond = respond,
    .initial_modulus = initial_modulus,
};

}  // namespace thinwall
