#include "engine/material/PrincipalResponse.hpp"

#include <cmath>

namespace thinwall {

PrincipalFrame principal_frame(const Eigen::Vector3d& c) {
  const double half_difference = 0.5 * (c[0] - c[1]);
  const double radius = std::hypot(half_difference, c[2]);
  const double angle = 0.5 * std::atan2(c[2], half_difference);
  const double cosine = std::cos(angle), sine = std::sin(angle);
  PrincipalFrame frame;
  frame.first = 0.5 * (c[0] + c[1]) + radius;
  frame.second = (c[0] * c[1] - c[2] * c[2]) / frame.first;
  frame.difference = 2 * radius;
  frame.turning << cosine * cosine, sine * sine, cosine * sine,  //
      sine * sine, cosine * cosine, -cosine * sine,              //
      -2 * cosine * sine, 2 * cosine * sine, cosine * cosine - sine * sine;
  return frame;
}

WallLawResponse principal_response(const PrincipalDerivatives& w, const PrincipalFrame& frame) {
  Eigen::Matrix3d tangent;
  tangent << 4 * w.first_first, 4 * w.first_second, 0,  //
      4 * w.first_second, 4 * w.second_second, 0,       //
      0, 0, 2 * w.slope_ratio;
  const Eigen::Vector3d stress(2 * w.by_first, 2 * w.by_second, 0);
  WallLawResponse response;
  response.energy = w.energy;
  response.second_piola_kirchhoff = frame.turning.transpose() * stress;
  response.tangent = frame.turning.transpose() * tangent * frame.turning;
  return response;
}

}  // namespace thinwall
