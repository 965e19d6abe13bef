#include "studio/organs/generator/Fingerpad.hpp"

namespace thinwall {
namespace {

constexpr double kMillimetre = 1e-3;  // metres

/// y of the crease of the last joint, millimetres.
constexpr double kCrease = -15;

struct AxisRow {
  double y, z, radius;  // millimetres
};

/// Along the finger: the pulp is deepest under the whorl of the print and thins towards the joint.
const AxisRow kPulp[] = {{-30, 0.4, 7.2}, {-20, 0.4, 7.2}, {-12, 0.6, 7.4}, {-6, 1.0, 7.9},
                         {0, 1.2, 8.2},   {4, 1.0, 8},     {8, 0.8, 6.2},   {9.5, 0.6, 4.5}};

}  // namespace

OrganPlan plan_fingerpad() {
  const auto mm = [](double x, double y, double z) -> Eigen::Vector3d {
    return kMillimetre * Eigen::Vector3d(x, y, z);
  };
  std::vector<AxisPoint> axis;
  for (const AxisRow& row : kPulp) axis.push_back({mm(0, row.y, row.z), kMillimetre * row.radius});
  const ImplicitBody over_bone = half_space_body(mm(0, 0, 0), -Eigen::Vector3d::UnitZ());
  const ImplicitBody before_crease = half_space_body(mm(0, kCrease, 0), -Eigen::Vector3d::UnitY());
  OrganPlan plan;
  plan.body = smooth_intersection(smooth_intersection(swept_sphere_body(axis), before_crease, 5 * kMillimetre),
                                  over_bone, 3 * kMillimetre);
  plan.low = mm(-11, -18, -3);
  plan.high = mm(11, 17, 12);
  plan.grid_step = 0.4 * kMillimetre;
  plan.relative_edge_length = [](const Eigen::Vector3d&) { return 1.0; };
  plan.group_at = [](const Eigen::Vector3d& centre, const Eigen::Vector3d& normal) -> std::string {
    const Eigen::Vector3d at = centre / kMillimetre;
    if (normal[2] < -0.85 && at[2] < 1) return "base";
    if (normal[1] < -0.85 && at[1] < kCrease + 1) return "proximal_end";
    if (at[1] > 9) return "tip";
    return normal[2] > 0.5 ? "pad" : "sides";
  };
  return plan;
}

}  // namespace thinwall
