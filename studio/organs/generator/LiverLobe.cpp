#include "studio/organs/generator/LiverLobe.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

constexpr double kMillimetre = 1e-3;  // metres

Eigen::Vector3d mm(double x, double y, double z) {
  return kMillimetre * Eigen::Vector3d(x, y, z);
}

/// x of the cut to the left lobe, millimetres.
constexpr double kCut = 46;

/// The bulk under the diaphragm: an ellipsoid.
ImplicitBody dome() {
  const Eigen::Vector3d half_axes(82, 88, 64);
  const ImplicitBody ball = sphere_body(Eigen::Vector3d(0, -10, -38).cwiseQuotient(half_axes), 1);
  return stretched_body(ball, kMillimetre * half_axes);
}

/// Outside of a large ball below: hollow as the organs beneath have pressed it.
ImplicitBody above_viscera() {
  return outside_of(sphere_body(mm(-10, -40, -188), 180 * kMillimetre));
}

/// The thick round back, from the right to the cut.
ImplicitBody back() {
  return swept_sphere_body({{mm(-44, 26, -20), 27 * kMillimetre},
                            {mm(-22, 38, -20), 33 * kMillimetre},
                            {mm(10, 42, -16), 34 * kMillimetre},
                            {mm(40, 38, -12), 32 * kMillimetre},
                            {mm(70, 32, -8), 30 * kMillimetre}});
}

/// What the gallbladder leaves free: its bed, that ends in a notch of the inferior edge.
ImplicitBody gallbladder() {
  return swept_sphere_body({{mm(8, -100, -27), 17 * kMillimetre},
                            {mm(12, -75, -26), 17 * kMillimetre},
                            {mm(17, -42, -23), 14 * kMillimetre},
                            {mm(22, -14, -25), 8 * kMillimetre}});
}

}  // namespace

OrganPlan plan_liver_lobe() {
  const ImplicitBody wedge = smooth_intersection(dome(), above_viscera(), 16 * kMillimetre);
  const ImplicitBody whole = smooth_union(wedge, back(), 30 * kMillimetre);
  const ImplicitBody with_bed = smooth_intersection(whole, outside_of(gallbladder()), 16 * kMillimetre);
  const ImplicitBody right_of_cut = half_space_body(mm(kCut, 0, 0), Eigen::Vector3d::UnitX());
  OrganPlan plan;
  plan.body = smooth_intersection(with_bed, right_of_cut, 16 * kMillimetre);
  plan.low = mm(-95, -105, -75);
  plan.high = mm(60, 95, 45);
  plan.grid_step = 2.5 * kMillimetre;
  plan.relative_edge_length = [outer = dome(), inner = above_viscera(),
                               bed = gallbladder()](const Eigen::Vector3d& point) {
    // The edge runs where the dome meets the visceral surface or, in the notch, the bed.
    const double from_below = std::min(std::abs(inner(point).value), std::abs(bed(point).value));
    const double off_edge = (std::abs(outer(point).value) + from_below) / kMillimetre;
    return 0.4 + 0.6 * std::clamp(off_edge / 40, 0.0, 1.0);
  };
  plan.group_at = [outer = dome(), inner = above_viscera(), bed = gallbladder()](
                      const Eigen::Vector3d& centre, const Eigen::Vector3d& normal) -> std::string {
    const Eigen::Vector3d at = centre / kMillimetre;
    if (normal[0] > 0.85 && at[0] > kCut - 4) return "medial_face";
    if (normal[1] > 0.2 && normal[2] < -0.25 && at[1] > 40) return "bare_area";
    if (bed(centre).value < 3 * kMillimetre) return "gallbladder_bed";
    if (outer(centre).value > -7 * kMillimetre && std::abs(inner(centre).value) < 7 * kMillimetre && at[1] < 20) {
      return "inferior_edge";
    }
    return normal[2] < -0.1 ? "visceral_surface" : "dome";
  };
  return plan;
}

}  // namespace thinwall
