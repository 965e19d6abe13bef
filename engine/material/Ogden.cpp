#include <array>
#include <cmath>

#include "engine/material/IsotropicResponse.hpp"
#include "engine/material/PrincipalResponse.hpp"
#include "engine/material/WallLawRows.hpp"

namespace thinwall {
namespace {

constexpr std::array<LawParameter, 2> kParameters = {{
    {"modulus", "Pa", -1e12, false, 1e12, std::nullopt,
     "Factor mu_p; half the sum of mu_p alpha_p is the shear modulus at small strain, above zero."},
    {"exponent", "", -100, false, 100, std::nullopt, "Exponent alpha_p of the principal stretches, not zero."},
}};

/// (c1^b - c2^b) / (c1 - c2) with c1 - c2 = `difference`, exact to round-off where they are nearly or fully equal:
/// both differences are hyperbolic sines of half the logarithm of c1 / c2.
double power_ratio(double first, double second, double difference, double b) {
  const double half_log = 0.5 * std::log1p(difference / second);
  const double ratio = half_log == 0 ? b : std::sinh(b * half_log) / std::sinh(half_log);
  return std::pow(first * second, 0.5 * (b - 1)) * ratio;
}

/// A term mu/alpha (c1^a + c2^a + (c1 c2)^-a - 3) with a = alpha / 2.
void add_term(double modulus, double exponent, const PrincipalFrame& frame, PrincipalDerivatives& w) {
  const double c1 = frame.first, c2 = frame.second, a = 0.5 * exponent;
  const double power_1 = std::pow(c1, a), power_2 = std::pow(c2, a), across = 1 / (power_1 * power_2);
  const double log_1 = std::log(c1), log_2 = std::log(c2);
  const double half = 0.5 * modulus;
  w.energy += modulus / exponent * (std::expm1(a * log_1) + std::expm1(a * log_2) + std::expm1(-a * (log_1 + log_2)));
  w.by_first += half * (power_1 - across) / c1;
  w.by_second += half * (power_2 - across) / c2;
  w.first_first += half * ((a - 1) * power_1 + (a + 1) * across) / (c1 * c1);
  w.second_second += half * ((a - 1) * power_2 + (a + 1) * across) / (c2 * c2);
  w.first_second += half * a * across / (c1 * c2);
  w.slope_ratio += half * (power_ratio(c1, c2, frame.difference, a - 1) + across / (c1 * c2));
}

WallLawResponse respond(std::span<const double> parameters, const Eigen::Vector3d& c) {
  const PrincipalFrame frame = principal_frame(c);
  PrincipalDerivatives derivatives{};
  for (std::size_t k = 0; k + 1 < parameters.size(); k += 2) {
    add_term(parameters[k], parameters[k + 1], frame, derivatives);
  }
  WallLawResponse response = principal_response(derivatives, frame);
  if (!response.tangent.allFinite() || !std::isfinite(response.energy)) return beyond_the_law();
  return response;
}

double shear_modulus(std::span<const double> parameters) {
  double modulus = 0;
  for (std::size_t k = 0; k + 1 < parameters.size(); k += 2) modulus += 0.5 * parameters[k] * parameters[k + 1];
  return modulus;
}

double initial_modulus(std::span<const double> parameters) {
  return 3 * shear_modulus(parameters);
}

std::string complaint(std::span<const double> parameters) {
  for (std::size_t k = 1; k < parameters.size(); k += 2) {
    if (parameters[k] == 0) return "an exponent of zero resists nothing: leave the term out";
  }
  if (shear_modulus(parameters) > 0) return "";
  return "half the sum of modulus times exponent, the shear modulus at small strain, must be greater than 0: give each "
         "modulus the sign of its exponent";
}

}  // namespace

const WallLaw kOgden = {
    .name = "ogden",
    .formula = "W = sum of mu_p/alpha_p (l1^alpha_p + l2^alpha_p + l3^alpha_p - 3), l3 = 1/(l1 l2)",
    .source = "Ogden 1972; incompressible plane stress; l1, l2 principal stretches",
    .parameters = kParameters,
    .terms = "terms",
    .respond = respond,
    .initial_modulus = initial_modulus,
    .complaint = complaint,
};

}  // namespace thinwall
