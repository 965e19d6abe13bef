#include "studio/organs/generator/Gallbladder.hpp"

#include <algorithm>

namespace thinwall {
namespace {

constexpr double kMillimetre = 1e-3;  // metres

struct AxisRow {
  double x, y, z, radius;  // millimetres
};

/// From the fundus to the closed end of the duct. The neck turns to one side and the duct back, the S by which surgeons
/// know it; the duct's radius swings a little, as the spiral folds of Heister make it.
const AxisRow kAxis[] = {
    {20.5, 0, 0, 13.2},     {13, 0, 0.3, 16.4},    {3, 0, 0.6, 18},      {-8, 0.3, 0.6, 17},   {-19, 0.8, 0.2, 14},
    {-29, 1.8, -0.4, 10.5}, {-37, 3.4, -0.6, 7.6}, {-43.5, 5.6, 0, 5.2}, {-48.5, 7.4, 1, 3.6}, {-53, 7.2, 2, 2.7},
    {-56.6, 4.6, 2.2, 3.9}, {-59, 1.2, 1.8, 2.2},  {-61.2, -2, 1, 3.9},  {-64, -4.6, 0, 2.2},  {-67.6, -6, -1, 3.8},
    {-71.4, -6.4, -2, 2.4}, {-75, -6.2, -3, 3.4},  {-78.6, -5.8, -4, 3},
};

}  // namespace

OrganPlan plan_gallbladder() {
  std::vector<AxisPoint> axis;
  for (const AxisRow& row : kAxis) {
    axis.push_back({kMillimetre * Eigen::Vector3d(row.x, row.y, row.z), kMillimetre * row.radius});
  }
  const auto mm = [](double x, double y, double z) -> Eigen::Vector3d {
    return kMillimetre * Eigen::Vector3d(x, y, z);
  };
  // Hartmann's pouch, the bulge at the neck.
  const ImplicitBody pouch = sphere_body(mm(-36, -1.2, -2.2), 7.2 * kMillimetre);
  const ImplicitBody bag = smooth_union(swept_sphere_body(axis), pouch, 6 * kMillimetre);
  const ImplicitBody above_bed = half_space_body(mm(0, 0, -13.2), -Eigen::Vector3d::UnitZ());
  OrganPlan plan;
  plan.body = smooth_intersection(bag, above_bed, 7 * kMillimetre);
  plan.low = mm(-86, -24, -20);
  plan.high = mm(40, 24, 24);
  plan.relative_edge_length = [](const Eigen::Vector3d& point) {
    const double towards_duct = std::clamp((-25 - point[0] / kMillimetre) / 25, 0.0, 1.0);
    return 1 - 0.45 * towards_duct;
  };
  plan.group_at = [](const Eigen::Vector3d& centre, const Eigen::Vector3d& normal) -> std::string {
    const Eigen::Vector3d at = centre / kMillimetre;
    if (at[0] < -78) return "duct_end";
    if (at[0] < -49) return "duct";
    if (normal[2] < -0.85 && at[2] < -9 && at[0] > -30 && at[0] < 18) return "liver_bed";
    if (at[0] < -30) return "neck";
    return at[0] > 18 ? "fundus" : "body";
  };
  return plan;
}

}  // namespace thinwall
