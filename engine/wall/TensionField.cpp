#include "engine/wall/TensionField.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/material/PrincipalResponse.hpp"

namespace thinwall {
namespace {

/// Compression below this part of the stiffness counts as none: round-off of an unstrained wall must not fold it.
constexpr double kTautTolerance = 1e-12;

/// The direction n of the shortening that wrinkles hide, and t across it, as what n n^T, and the symmetric part of
/// n t^T, do to (E11, E22, 2 E12).
struct WrinkleFrame {
  Eigen::Vector3d shortening, turning, along;
};

WrinkleFrame wrinkle_frame(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {.shortening = {c * c, s * s, 2 * c * s},
          .turning = {-c * s, c * s, c * c - s * s},
          .along = {s * s, c * c, -2 * c * s}};
}

/// C + beta n n^T.
Eigen::Vector3d lengthened(const Eigen::Vector3d& c, double beta, const WrinkleFrame& frame) {
  return c + beta * Eigen::Vector3d(frame.shortening[0], frame.shortening[1], 0.5 * frame.shortening[2]);
}

struct Wrinkled {
  WrinkleFrame frame;
  double beta;
  WallLawResponse response;  // of C + beta n n^T
};

/// Least energy over beta for wrinkles of one direction: the root of n . S n, which grows with beta. Newton's method
/// within a bracket.
Wrinkled wrinkle_along(const Material& material, const Eigen::Vector3d& c, double angle) {
  Wrinkled result{.frame = wrinkle_frame(angle), .beta = 0, .response = {}};
  const auto pull = [&](double beta) {
    result.beta = beta;
    result.response = material.law->respond(material.parameters, lengthened(c, beta, result.frame));
    return result.response.second_piola_kirchhoff.dot(result.frame.shortening);
  };
  if (pull(0) >= 0) return result;
  double low = 0, high = 1;
  while (pull(high) < 0 && high < 1e6) {
    low = high;
    high *= 2;
  }
  double beta = 0.5 * (low + high);
  for (int turn = 0; turn < 60; ++turn) {
    const double value = pull(beta);
    const Eigen::Matrix3d& tangent = result.response.tangent;
    const double slope = 0.5 * result.frame.shortening.dot(tangent * result.frame.shortening);
    (value < 0 ? low : high) = beta;
    double next = beta - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - beta) <= 1e-15 * (1 + beta)) break;
    beta = next;
  }
  return result;
}

/// Turns the wrinkles until the wall across them bears no shear, n . S t = 0: Newton's method on the energy that is
/// already least in beta, with its decrease watched over.
Wrinkled wrinkle(const Material& material, const Eigen::Vector3d& c, double angle) {
  Wrinkled best = wrinkle_along(material, c, angle);
  for (int turn = 0; turn < 40; ++turn) {
    const Eigen::Vector3d& stress = best.response.second_piola_kirchhoff;
    const Eigen::Matrix3d& tangent = best.response.tangent;
    const WrinkleFrame& frame = best.frame;
    const double beta = best.beta, shear = stress.dot(frame.turning);
    if (beta == 0 || std::abs(shear) <= 1e-14 * tangent.norm()) break;
    const double mixed = 0.5 * beta * frame.shortening.dot(tangent * frame.turning) + shear;
    const double curvature = beta * beta * frame.turning.dot(tangent * frame.turning) +
                             beta * stress.dot(frame.along - frame.shortening) -
                             mixed * mixed / (0.25 * frame.shortening.dot(tangent * frame.shortening));
    double step = curvature > 0 ? -beta * shear / curvature : -std::copysign(0.3, shear);
    step = std::clamp(step, -0.3, 0.3);
    bool fell = false;
    for (int halving = 0; halving < 30 && !fell; ++halving, step *= 0.5) {
      const Wrinkled trial = wrinkle_along(material, c, angle + step);
      const double trial_shear = trial.response.second_piola_kirchhoff.dot(trial.frame.turning);
      // Near the minimum energies no longer differ in their last digits, but the shear still falls.
      const double noise = 1e-14 * std::abs(best.response.energy);
      fell = trial.response.energy < best.response.energy - noise ||
             (trial.response.energy <= best.response.energy + noise && std::abs(trial_shear) < std::abs(shear));
      if (!fell) continue;
      angle += step;
      best = trial;
    }
    if (!fell) break;
  }
  return best;
}

/// The tangent when beta and the direction follow the strain: the law's, less what they give way. `give`: what both do
/// to the strain; where wrinkles have hardly begun, the tension along them keeps their direction.
Eigen::Matrix3d relaxed_tangent(const Wrinkled& wrinkled) {
  const Eigen::Matrix3d& tangent = wrinkled.response.tangent;
  const double tension = wrinkled.response.second_piola_kirchhoff.dot(wrinkled.frame.along);
  const double largest = 1e12 * tangent.norm();
  const double hold = wrinkled.beta > 0 ? std::min(std::max(tension, 0.0) / wrinkled.beta, largest) : largest;
  Eigen::Matrix<double, 3, 2> give;
  give << wrinkled.frame.shortening, wrinkled.frame.turning;
  Eigen::Matrix2d resistance = give.transpose() * tangent * give;
  resistance(1, 1) += hold;
  const Eigen::Matrix<double, 3, 2> stress = tangent * give;
  return tangent - stress * resistance.inverse() * stress.transpose();
}

double smallest_principal(const Eigen::Vector3d& s) {
  return 0.5 * (s[0] + s[1]) - std::hypot(0.5 * (s[0] - s[1]), s[2]);
}

WallLawResponse relaxed(const Material& material, const Eigen::Vector3d& c) {
  const WallLawResponse taut = material.law->respond(material.parameters, c);
  const Eigen::Vector3d& s = taut.second_piola_kirchhoff;
  if (!std::isfinite(taut.energy) || smallest_principal(s) >= -kTautTolerance * taut.tangent.norm()) return taut;
  if (principal_frame(c).first <= 1) {
    return {.energy = 0, .second_piola_kirchhoff = Eigen::Vector3d::Zero(), .tangent = Eigen::Matrix3d::Zero()};
  }
  // The wall shortens first where it is pressed most.
  const double angle = 0.5 * std::atan2(-2 * s[2], s[1] - s[0]);
  const Wrinkled wrinkled = wrinkle(material, c, angle);
  return {.energy = wrinkled.response.energy,
          .second_piola_kirchhoff = wrinkled.response.second_piola_kirchhoff,
          .tangent = relaxed_tangent(wrinkled)};
}

}  // namespace

WallLawResponse tension_field_response(const Material& material, const Eigen::Vector3d& c) {
  WallLawResponse response = relaxed(material, c);
  const Eigen::Vector3d strain(0.5 * (c[0] - 1), 0.5 * (c[1] - 1), c[2]);
  const Eigen::Matrix3d stiffness =
      kTensionFieldResidual * material.law->respond(material.parameters, Eigen::Vector3d(1, 1, 0)).tangent;
  response.energy += 0.5 * strain.dot(stiffness * strain);
  response.second_piola_kirchhoff += stiffness * strain;
  response.tangent += stiffness;
  return response;
}

}  // namespace thinwall
