#include "engine/wall/TensionField.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

/// Compression below this part of the stiffness counts as none: round-off of an unstrained wall must not fold it.
constexpr double kTautTolerance = 1e-12;

/// Turns in which the depth of wrinkles of one direction is looked for: by Newton's method first, then by halving.
constexpr int kNewtonTurns = 15;
constexpr int kMostTurns = 80;

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

/// Stress of a neo-Hookean wall over its modulus, (S11, S22, S12): where a law has no answer it tells whether the wall
/// is crushed there or stretched too far. A wall crushed to a line, det C = 0, has a stress without bound: then what
/// its components are in proportion to, minus the cofactors of C.
Eigen::Vector3d rubber_stress(const Eigen::Vector3d& c) {
  const double d = c[0] * c[1] - c[2] * c[2];
  const Eigen::Vector3d push(c[1], c[0], -c[2]);
  return d == 0 ? Eigen::Vector3d(-push) : Eigen::Vector3d(Eigen::Vector3d(1, 1, 0) - push / (d * d));
}

/// Least energy over beta for wrinkles of one direction: the root of n . S n, which grows with beta. Newton's method
/// within a bracket. `taut`: the law's answer for C itself.
Wrinkled wrinkle_along(const Material& material, const Eigen::Vector3d& c, double angle, const WallLawResponse& taut) {
  Wrinkled result{.frame = wrinkle_frame(angle), .beta = 0, .response = taut};
  const auto pull_of_response = [&] {
    const bool has_answer = std::isfinite(result.response.energy);
    return (has_answer ? result.response.second_piola_kirchhoff
                       : rubber_stress(lengthened(c, result.beta, result.frame)))
        .dot(result.frame.shortening);
  };
  const auto pull = [&](double beta) {
    result.beta = beta;
    result.response = material.law->respond(material.parameters, lengthened(c, beta, result.frame));
    return pull_of_response();
  };
  if (pull_of_response() >= 0) return result;
  double low = 0, high = 1;
  while (pull(high) < 0 && high < 1e6) {
    low = high;
    high *= 2;
  }
  double beta = 0.5 * (low + high);
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const double value = pull(beta);
    const Eigen::Matrix3d& tangent = result.response.tangent;
    const double slope = 0.5 * result.frame.shortening.dot(tangent * result.frame.shortening);
    (value < 0 ? low : high) = beta;
    double next = beta - value / slope;
    // A law that stiffens exponentially makes Newton's steps as short as its exponent is steep.
    const bool is_slow = turn >= kNewtonTurns && std::abs(next - beta) > 1e-12 * (1 + beta);
    if (is_slow || !(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - beta) <= 1e-15 * (1 + beta)) break;
    beta = next;
  }
  return result;
}

Eigen::Matrix2d matrix_of(const Eigen::Vector3d& tensor) {
  Eigen::Matrix2d matrix;
  matrix << tensor[0], tensor[2], tensor[2], tensor[1];
  return matrix;
}

/// Newton's step, with the sizes of the eigenvalues where some are negative.
Eigen::Vector2d descent(const Eigen::Matrix2d& second, const Eigen::Vector2d& gradient) {
  const double mean = 0.5 * (second(0, 0) + second(1, 1)), half = 0.5 * (second(0, 0) - second(1, 1));
  const double spread = std::hypot(half, second(0, 1));
  if (mean - spread > 0) return -second.inverse() * gradient;
  const double angle = 0.5 * std::atan2(second(0, 1), half);
  const Eigen::Vector2d large(std::cos(angle), std::sin(angle)), small(-large[1], large[0]);
  const double least = 1e-6 * (std::abs(mean) + spread);
  return -large * (large.dot(gradient) / std::max(std::abs(mean + spread), least)) -
         small * (small.dot(gradient) / std::max(std::abs(mean - spread), least));
}

/// Turns the wrinkles until the wall across them bears no shear. With v = sqrt(beta) n the energy of C + v v^T has the
/// gradient S v and the second derivatives S + M^T T M, where M takes a change of v to one of (E11, E22, 2 E12). As the
/// energy is convex in C, where S v = 0 and S has no compression it is the least. Newton's method with its decrease
/// watched over, down to round-off: what is left of it would be noise in the forces of walls that are all but slack.
Wrinkled wrinkle(const Material& material, const Eigen::Vector3d& c, double angle, const WallLawResponse& taut) {
  Wrinkled best = wrinkle_along(material, c, angle, taut);
  const double shear = best.response.second_piola_kirchhoff.dot(best.frame.turning);
  if (best.beta == 0 || std::abs(shear) <= 1e-14 * best.response.tangent.norm()) return best;
  Eigen::Vector2d v = std::sqrt(best.beta) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  Eigen::Vector2d gradient = matrix_of(best.response.second_piola_kirchhoff) * v;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const Eigen::Matrix3d& tangent = best.response.tangent;
    const double round_off = 1e-16 * tangent.norm();
    if (gradient.norm() <= round_off * v.norm()) break;
    Eigen::Matrix<double, 3, 2> strain;
    strain << v[0], 0, 0, v[1], v[1], v[0];
    Eigen::Vector2d step =
        descent(matrix_of(best.response.second_piola_kirchhoff) + strain.transpose() * tangent * strain, gradient);
    bool fell = false;
    for (int halving = 0; halving < 30 && !fell; ++halving, step *= 0.5) {
      const Eigen::Vector2d w = v + step;
      const WallLawResponse trial =
          material.law->respond(material.parameters, c + Eigen::Vector3d(w[0] * w[0], w[1] * w[1], w[0] * w[1]));
      const Eigen::Vector2d trial_gradient = matrix_of(trial.second_piola_kirchhoff) * w;
      // Near the minimum energies no longer differ in their last digits, but the gradient still falls.
      const double noise = 10 * round_off;
      fell = trial.energy < best.response.energy - noise ||
             (trial.energy <= best.response.energy + noise && trial_gradient.norm() < gradient.norm());
      if (!fell) continue;
      v = w;
      best.response = trial;
      gradient = trial_gradient;
    }
    if (!fell) break;
  }
  best.beta = v.squaredNorm();
  best.frame = wrinkle_frame(std::atan2(v[1], v[0]));
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

double largest_principal(const Eigen::Vector3d& tensor) {
  return 0.5 * (tensor[0] + tensor[1]) + std::hypot(0.5 * (tensor[0] - tensor[1]), tensor[2]);
}

double smallest_principal(const Eigen::Vector3d& tensor) {
  return 0.5 * (tensor[0] + tensor[1]) - std::hypot(0.5 * (tensor[0] - tensor[1]), tensor[2]);
}

WallLawResponse relaxed(const Material& material, const Eigen::Vector3d& c) {
  WallLawResponse taut = material.law->respond(material.parameters, c);
  // A law may end where the wall is crushed as well as where it is stretched: wrinkles spare it the first.
  const double stiffness = taut.tangent.norm();
  const bool has_answer = std::isfinite(taut.energy) && std::isfinite(stiffness);
  const Eigen::Vector3d s = has_answer ? taut.second_piola_kirchhoff : rubber_stress(c);
  // A wall crushed to a line is stiff beyond measure, and what is round-off beside that would be compression.
  const double width = std::clamp(smallest_principal(c), 0.0, 1.0);
  if (smallest_principal(s) >= (has_answer ? -kTautTolerance * width * stiffness : 0)) return taut;
  if (largest_principal(c) <= 1) {
    return {.energy = 0, .second_piola_kirchhoff = Eigen::Vector3d::Zero(), .tangent = Eigen::Matrix3d::Zero()};
  }
  // The wall shortens first where it is pressed most.
  const double angle = 0.5 * std::atan2(-2 * s[2], s[1] - s[0]);
  const Wrinkled wrinkled = wrinkle(material, c, angle, taut);
  if (!std::isfinite(wrinkled.response.energy)) return wrinkled.response;
  return {.energy = wrinkled.response.energy,
          .second_piola_kirchhoff = wrinkled.response.second_piola_kirchhoff,
          .tangent = relaxed_tangent(wrinkled)};
}

}  // namespace

WallLawResponse tension_field_response(const Material& material, const Eigen::Vector3d& c, double slack_stiffness) {
  WallLawResponse response = relaxed(material, c);
  if (slack_stiffness == 0) return response;
  const Eigen::Vector3d strain(0.5 * (c[0] - 1), 0.5 * (c[1] - 1), c[2]);
  const Eigen::Matrix3d stiffness =
      slack_stiffness * material.law->respond(material.parameters, Eigen::Vector3d(1, 1, 0)).tangent;
  response.energy += 0.5 * strain.dot(stiffness * strain);
  response.second_piola_kirchhoff += stiffness * strain;
  response.tangent += stiffness;
  return response;
}

}  // namespace thinwall
