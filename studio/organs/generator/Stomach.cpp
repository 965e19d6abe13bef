#include "studio/organs/generator/Stomach.hpp"

#include <algorithm>

namespace thinwall {
namespace {

constexpr double kMillimetre = 1e-3;  // metres

/// How deep the stomach is from front to back for its breadth.
constexpr double kDepth = 0.84;

struct AxisRow {
  double x, y, z, radius;  // millimetres
};

/// From the fundus down the body, around the angular notch through the antrum, to the duodenum. The pylorus is the
/// narrow ring before the duodenum widens to its cap.
const AxisRow kStomach[] = {
    {40, 66, -14, 33}, {38, 50, -12, 43},  {33, 26, -6, 44},    {27, 2, 0, 41},     {17, -22, 8, 37},
    {0, -42, 15, 31},  {-24, -52, 18, 27}, {-46, -49, 16, 25},  {-62, -38, 12, 22}, {-74, -26, 7, 16},
    {-81, -18, 3, 6},  {-87, -11, 0, 12},  {-93, -2, -4, 15.5}, {-97, 8, -8, 15},   {-99, 17, -12, 13},
};

/// The gullet comes from the hiatus of the diaphragm and meets the stomach at a sharp notch with the fundus, the angle
/// of His.
const AxisRow kGullet[] = {
    {20, 36, -8, 11}, {8, 52, -10, 11}, {-3, 66, -12, 9.5}, {-10, 80, -15, 9}, {-13, 95, -18, 9},
};

template <typename Rows>
ImplicitBody tube(const Rows& rows) {
  std::vector<AxisPoint> axis;
  for (const AxisRow& row : rows) {
    axis.push_back({kMillimetre * Eigen::Vector3d(row.x, row.y, row.z / kDepth), kMillimetre * row.radius});
  }
  return swept_sphere_body(axis);
}

double ramp(double from, double to, double value) {
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

/// The place as millimetres; the outward normal tells the curvatures.
std::string part_of(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) {
  if (at[1] > 45 && at[0] < 6) {
    if (at[1] > 97) return "oesophagus_end";
    return at[1] > 72 ? "oesophagus" : "cardia";
  }
  if (at[0] < -84) return at[1] > 22 ? "duodenum_end" : "duodenum";
  if (at[0] < -76) return "pylorus";
  // The borders to the lesser and the greater omentum: where the wall stands upright between front and back.
  const bool is_on_border = normal[2] < 0.26 && normal[2] > -0.26 && at[1] < 55;
  if (is_on_border) return 0.8 * normal[1] - 0.6 * normal[0] > 0 ? "lesser_curvature" : "greater_curvature";
  if (at[0] < -20 && at[1] < 0) return "antrum";
  return at[1] > 62 ? "fundus" : "body";
}

}  // namespace

OrganPlan plan_stomach() {
  OrganPlan plan;
  plan.body = stretched_body(smooth_union(tube(kStomach), tube(kGullet), 12 * kMillimetre), {1, 1, kDepth});
  plan.low = kMillimetre * Eigen::Vector3d(-125, -95, -70);
  plan.high = kMillimetre * Eigen::Vector3d(95, 115, 60);
  plan.grid_step = 3 * kMillimetre;
  plan.relative_edge_length = [](const Eigen::Vector3d& point) {
    const Eigen::Vector3d at = point / kMillimetre;
    const double towards_duodenum = ramp(-50, -74, at[0]);
    const double towards_gullet = ramp(30, 4, at[0]) * ramp(30, 50, at[1]);
    return 1 - 0.5 * std::max(towards_duodenum, towards_gullet);
  };
  plan.group_at = [](const Eigen::Vector3d& centre, const Eigen::Vector3d& normal) {
    return part_of(centre / kMillimetre, normal);
  };
  return plan;
}

}  // namespace thinwall
