#include "engine/equilibrium/PinchedWall.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace thinwall {
namespace {

/// Part of its thickness by which jaws have squeezed a wall that lies in their middle.
constexpr double kCentred = 0.25;

/// Cosine of the angle within which what a jaw touches first is taken to be its plane side.
constexpr double kPlane = 1 - 1e-6;

/// The wall around a vertex, across.
struct WallAcross {
  double thickness = 0;  // metres, as it is stretched now
  double modulus = 0;    // pascal, Young's
};

/// (vertices)
std::vector<WallAcross> walls_across(const BodyModel& model, const Eigen::VectorXd& position) {
  std::vector<WallAcross> walls(model.vertices());
  std::vector<double> volume(walls.size()), area(walls.size());  // metres^3, of the wall; metres^2
  for (int t = 0; t < model.triangles(); ++t) {
    const auto corners = corners_of(model.surface[t], position);
    const double now = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    const double own = model.rest[t].area * model.rest[t].thickness;
    const Material& material = model.material(t);
    const double modulus = material.law->initial_modulus(material.parameters);
    for (const int vertex : model.surface[t]) {
      volume[vertex] += own;
      area[vertex] += now;
      walls[vertex].modulus += own * modulus;
    }
  }
  for (std::size_t v = 0; v < walls.size(); ++v) {
    if (area[v] == 0 || volume[v] == 0) continue;
    walls[v] = {.thickness = volume[v] / area[v], .modulus = walls[v].modulus / volume[v]};
  }
  return walls;
}

}  // namespace

PinchedWall pinched_wall(const BodyModel& model, const Eigen::VectorXd& position, const ToolSolid& one,
                         const ToolSolid& other) {
  PinchedWall pinched;
  const std::vector<WallAcross> walls = walls_across(model, position);
  for (int s = 0; s < static_cast<int>(model.sites.size()); ++s) {
    const ContactSite& site = model.sites[s];
    if (site.part != SitePart::kCorner) continue;
    const WallAcross& wall = walls[model.surface[site.triangle][site.corner]];
    const auto corners = corners_of(model.surface[site.triangle], position);
    const SolidGap to_one = gap_from_inner_side(one, inner_side(one, other), corners, site.corner);
    const SolidGap to_other = gap_from_inner_side(other, inner_side(other, one), corners, site.corner);
    const double room = to_one.gap + to_other.gap;
    if (room >= wall.thickness) continue;
    const auto lies_before = [&](const ToolSolid& solid, const SolidGap& gap) {
      return signed_distance(solid, corners[site.corner]).normal.dot(gap.normal) > kPlane;
    };
    if (!lies_before(one, to_one) || !lies_before(other, to_other)) continue;
    const double centred = std::min(1.0, (wall.thickness - room) / (kCentred * wall.thickness));
    const double half = 0.5 * wall.thickness, aside = (1 - centred * centred) * 0.5 * (to_one.gap - to_other.gap);
    const double stiffness = wall.modulus * site.area / half;
    pinched.one.push_back({.site = s, .potential = {.onset = half + aside, .stiffness = stiffness}});
    pinched.other.push_back({.site = s, .potential = {.onset = half - aside, .stiffness = stiffness}});
  }
  return pinched;
}

double inner_side(const ToolSolid& jaw, const ToolSolid& other) {
  return (other.center - jaw.center).dot(jaw.frame.col(0)) > 0 ? 1 : -1;
}

SolidGap gap_from_inner_side(const ToolSolid& jaw, double side, const std::array<Eigen::Vector3d, 3>& corners,
                             int corner) {
  SolidGap gap;
  gap.part = SitePart::kCorner;
  gap.normal = side * jaw.frame.col(0);
  gap.gap = gap.normal.dot(corners[corner] - jaw.center) - (jaw.core.x() + jaw.radius);
  gap.weights[corner] = 1;
  gap.gradient.setZero();
  gap.gradient.segment<3>(3 * corner) = gap.normal;
  gap.hessian.setZero();
  return gap;
}

}  // namespace thinwall
