#include "renderer/camera/Lens.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thinwall {
namespace {

/// 1 + k1 r^2 + k2 r^4 + k3 r^6 and its derivative by r^2.
struct Radial {
  double value = 1;
  double slope = 0;
};

Radial radial(const LensDistortion& lens, double squared) {
  return {1 + squared * (lens.k1 + squared * (lens.k2 + squared * lens.k3)),
          lens.k1 + squared * (2 * lens.k2 + 3 * lens.k3 * squared)};
}

/// How fast r (1 + k1 r^2 + ...) grows with r.
double growth(const LensDistortion& lens, double squared) {
  const Radial part = radial(lens, squared);
  return part.value + 2 * squared * part.slope;
}

Tangents image_of(const LensDistortion& lens, Tangents ideal) {
  const auto [x, y] = ideal;
  const double squared = x * x + y * y;
  const double scale = radial(lens, squared).value;
  return {x * scale + 2 * lens.p1 * x * y + lens.p2 * (squared + 2 * x * x),
          y * scale + lens.p1 * (squared + 2 * y * y) + 2 * lens.p2 * x * y};
}

/// How the picture's point moves with the ideal one; xy stands for yx, too.
struct Slopes {
  double xx = 1, xy = 0, yy = 1;
  double determinant() const { return xx * yy - xy * xy; }
};

Slopes slopes(const LensDistortion& lens, Tangents ideal) {
  const auto [x, y] = ideal;
  const Radial part = radial(lens, x * x + y * y);
  return {.xx = part.value + 2 * x * x * part.slope + 2 * lens.p1 * y + 6 * lens.p2 * x,
          .xy = 2 * x * y * part.slope + 2 * lens.p1 * x + 2 * lens.p2 * y,
          .yy = part.value + 2 * y * y * part.slope + 6 * lens.p1 * y + 2 * lens.p2 * x};
}

/// One step of Newton's method towards the ideal point whose picture is `seen`.
Tangents improved(const LensDistortion& lens, Tangents ideal, Tangents seen) {
  const Slopes by = slopes(lens, ideal);
  const Tangents now = image_of(lens, ideal);
  const double dx = now[0] - seen[0];
  const double dy = now[1] - seen[1];
  return {ideal[0] - (by.yy * dx - by.xy * dy) / by.determinant(),
          ideal[1] - (by.xx * dy - by.xy * dx) / by.determinant()};
}

/// The ideal point near `start` that the lens puts at `seen`; nothing where there is none, or beyond a fold.
std::optional<Tangents> ideal_near(const LensDistortion& lens, Tangents start, Tangents seen) {
  constexpr int kMostSteps = 100;  // far out, powers of seven let each step come nearer by a seventh only
  constexpr double kAccuracy = 1e-12;
  Tangents ideal = start;
  for (int step = 0; step < kMostSteps; ++step) {
    const Tangents next = improved(lens, ideal, seen);
    if (!std::isfinite(next[0]) || !std::isfinite(next[1])) return std::nullopt;
    const double change = std::hypot(next[0] - ideal[0], next[1] - ideal[1]);
    ideal = next;
    if (change > kAccuracy * (1 + std::hypot(seen[0], seen[1]))) continue;
    return slopes(lens, ideal).determinant() > 0 ? std::optional(ideal) : std::nullopt;
  }
  return std::nullopt;
}

/// The first zero of `growth`, a cubic in the squared radius that begins at one. All its zeros lie above a tenth of the
/// scale below; steps of half a percent part any two of them that could matter.
double radius_of_the_fold(const LensDistortion& lens) {
  constexpr double kFirst = 0.01;
  constexpr double kLast = 1e9;
  constexpr double kStep = 1.005;
  const double scale = std::abs(lens.k1) + std::sqrt(std::abs(lens.k2)) + std::cbrt(std::abs(lens.k3));
  if (scale == 0) return std::numeric_limits<double>::infinity();
  for (double units = kFirst; units < kLast; units *= kStep) {
    if (growth(lens, units / scale) > 0) continue;
    double low = units / kStep / scale;
    double high = units / scale;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (growth(lens, middle) > 0 ? low : high) = middle;
    }
    return std::sqrt(low);
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

Lens::Lens(const LensDistortion& distortion)
    : distortion_(distortion), unfolded_radius_(radius_of_the_fold(distortion)) {}

Tangents Lens::distorted(Tangents ideal) const {
  return image_of(distortion_, ideal);
}

std::optional<Tangents> Lens::undistorted(Tangents seen) const {
  const double radius = std::hypot(seen[0], seen[1]);
  // Newton's method starts on this side of the fold.
  const double start = std::min(1.0, 0.9 * unfolded_radius_ / std::max(radius, 1e-300));
  const auto is_before_the_fold = [&](Tangents ideal) { return std::hypot(ideal[0], ideal[1]) <= unfolded_radius_; };
  if (const auto ideal = ideal_near(distortion_, {start * seen[0], start * seen[1]}, seen);
      ideal && is_before_the_fold(*ideal)) {
    return ideal;
  }
  // Near a fold that is not round a start so far off may lead nowhere, or beyond it: on from the middle in small parts.
  constexpr int kParts = 64;
  Tangents ideal = {0, 0};
  for (int k = 1; k <= kParts; ++k) {
    const double part = static_cast<double>(k) / kParts;
    const auto next = ideal_near(distortion_, ideal, {part * seen[0], part * seen[1]});
    if (!next || !is_before_the_fold(*next)) return std::nullopt;
    ideal = *next;
  }
  return ideal;
}

bool Lens::is_unfolded(Tangents ideal) const {
  if (!(std::hypot(ideal[0], ideal[1]) <= unfolded_radius_)) return false;
  if (distortion_.p1 == 0 && distortion_.p2 == 0) return true;  // round folds are all that there are
  constexpr int kParts = 32;
  for (int k = 1; k <= kParts; ++k) {
    const double part = static_cast<double>(k) / kParts;
    if (!(slopes(distortion_, {part * ideal[0], part * ideal[1]}).determinant() > 0)) return false;
  }
  return true;
}

}  // namespace thinwall
