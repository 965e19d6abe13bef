#pragma once

#include <array>
#include <optional>

namespace thinwall {

/// Where a ray meets the plane at distance one before the camera, or where its picture lands there: x to the right, y
/// down, as tangents of angles off the line of sight. In pixels of a picture of `size` whose half fields of view have
/// the tangents tx and ty, such a point lies at (width / 2 (1 + x / tx), height / 2 (1 + y / ty)) from the upper left
/// corner; OpenCV, which counts from the middle of the first pixel, writes half a pixel less.
using Tangents = std::array<double, 2>;

/// How a lens bends rays off the pinhole's: radial and tangential coefficients in OpenCV's names, order and sense
/// (Brown 1966). With r the radius of the ideal point (x, y) the picture's point is
///   x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2),
///   y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y.
struct LensDistortion {
  double k1 = 0;
  double k2 = 0;
  double p1 = 0;
  double p2 = 0;
  double k3 = 0;
  friend bool operator==(const LensDistortion&, const LensDistortion&) = default;
};

/// A lens as a map of the picture's plane, forward and back.
class Lens {
 public:
  explicit Lens(const LensDistortion& distortion = {});

  /// Where the lens puts the ideal point of a pinhole.
  Tangents distorted(Tangents ideal) const;

  /// The ideal point that the lens puts at `seen`: the inverse of `distorted` to 1e-12. Nothing where no ray arrives.
  std::optional<Tangents> undistorted(Tangents seen) const;

  /// Whether the lens is one-to-one all the way from the middle to an ideal point: before any fold, also those that the
  /// tangential coefficients make.
  bool is_unfolded(Tangents ideal) const;

  /// The radius of ideal points up to which the radial part of the lens is one-to-one: the least at which
  /// r (1 + k1 r^2 + k2 r^4 + k3 r^6) stops growing, infinite when it never does. Beyond, the polynomial folds the
  /// plane over.
  double unfolded_radius() const { return unfolded_radius_; }

  const LensDistortion& distortion() const { return distortion_; }

 private:
  LensDistortion distortion_;
  double unfolded_radius_;
};

}  // namespace thinwall
