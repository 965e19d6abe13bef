#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace thinwall {

/// A number with two independent infinitesimal parts and their product (Fike and Alonso 2011): carries exact first and
/// second derivatives through any formula, so that tests have derivatives that owe nothing to the code under test.
struct HyperDual {
  double value = 0, first = 0, second = 0, both = 0;

  HyperDual(double number = 0) : value(number) {}  // NOLINT: numbers mix with it as they do with double
  HyperDual(double number, double along_first, double along_second, double along_both)
      : value(number), first(along_first), second(along_second), both(along_both) {}

  friend HyperDual operator+(const HyperDual& a, const HyperDual& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second, a.both + b.both};
  }
  friend HyperDual operator-(const HyperDual& a, const HyperDual& b) {
    return {a.value - b.value, a.first - b.first, a.second - b.second, a.both - b.both};
  }
  friend HyperDual operator*(const HyperDual& a, const HyperDual& b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first, a.second * b.value + a.value * b.second,
            a.both * b.value + a.first * b.second + a.second * b.first + a.value * b.both};
  }
  /// f(a), given f, f' and f'' at its value.
  static HyperDual chain(const HyperDual& a, double f, double slope, double curvature) {
    return {f, slope * a.first, slope * a.second, slope * a.both + curvature * a.first * a.second};
  }
  friend HyperDual operator/(const HyperDual& a, const HyperDual& b) {
    const double inverse = 1 / b.value;
    return a * chain(b, inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
  }
  friend HyperDual sqrt(const HyperDual& a) {
    const double root = std::sqrt(a.value);
    return chain(a, root, 0.5 / root, -0.25 / (root * a.value));
  }
  friend HyperDual exp(const HyperDual& a) {
    const double power = std::exp(a.value);
    return chain(a, power, power, power);
  }
  friend HyperDual log(const HyperDual& a) {
    return chain(a, std::log(a.value), 1 / a.value, -1 / (a.value * a.value));
  }
  friend HyperDual atan(const HyperDual& a) {
    const double slope = 1 / (1 + a.value * a.value);
    return chain(a, std::atan(a.value), slope, -2 * a.value * slope * slope);
  }
  friend HyperDual pow(const HyperDual& a, double exponent) {
    return chain(a, std::pow(a.value, exponent), exponent * std::pow(a.value, exponent - 1),
                 exponent * (exponent - 1) * std::pow(a.value, exponent - 2));
  }
};

using DualVector = std::array<HyperDual, 3>;

inline DualVector operator-(const DualVector& a, const DualVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline HyperDual dot(const DualVector& a, const DualVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline DualVector cross(const DualVector& a, const DualVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline HyperDual norm(const DualVector& a) {
  return sqrt(dot(a, a));
}
inline DualVector dual(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// Value, gradient and Hessian of a function of three corners, in the order (x0, y0, z0, x1, ..., z2).
struct CornerDerivatives {
  double value = 0;
  Eigen::Matrix<double, 9, 1> gradient;
  Eigen::Matrix<double, 9, 9> hessian;
};

/// `function` takes a `const std::array<DualVector, 3>&` and gives a HyperDual.
template <typename Function>
CornerDerivatives corner_derivatives(const Function& function, const std::array<Eigen::Vector3d, 3>& corners) {
  CornerDerivatives result;
  for (int i = 0; i < 9; ++i) {
    for (int j = i; j < 9; ++j) {
      std::array<DualVector, 3> moved = {dual(corners[0]), dual(corners[1]), dual(corners[2])};
      moved[i / 3][i % 3].first = 1;
      moved[j / 3][j % 3].second = 1;
      const HyperDual answer = function(moved);
      result.value = answer.value;
      result.gradient[i] = answer.first;
      result.hessian(i, j) = result.hessian(j, i) = answer.both;
    }
  }
  return result;
}

}  // namespace thinwall
