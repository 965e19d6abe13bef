// What closes a body whose rim is free: the cone from the rim's mean point.

#include "engine/equilibrium/CapFans.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "engine/equilibrium/Equilibrium.hpp"
#include "engine/fluid/EnclosedVolume.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

using Points = std::vector<Eigen::Vector3d>;

double volume_below(const CapSurface& caps, const Points& points) {
  double volume = 0;
  for (std::size_t t = 0; t < caps.triangles.size(); ++t) {
    const Eigen::Vector3i& corner = caps.triangles[t];
    volume += caps.share[t] * volume_of({points[corner[0]], points[corner[1]], points[corner[2]]});
  }
  return volume;
}

/// A square of 20 mm at a height of 5 mm under a cap of two triangles, with more vertices on its sides if there are.
SurfaceMesh square(const Points& on_first_side) {
  SurfaceMesh mesh;
  mesh.vertices = {{-0.01, -0.01, 0.005}};
  mesh.vertices.insert(mesh.vertices.end(), on_first_side.begin(), on_first_side.end());
  mesh.vertices.insert(mesh.vertices.end(), {{0.01, -0.01, 0.005}, {0.01, 0.01, 0.005}, {-0.01, 0.01, 0.005}});
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  for (int k = 0; k + 1 < last; ++k) mesh.cap_triangles.emplace_back(last, k, k + 1);
  return mesh;
}

TEST(CapFans, PullAtEveryVertexOfAnEvenRimAlike) {
  const SurfaceMesh mesh = make_hemisphere(20e-3, 256);
  const CapSurface caps = spread_caps(mesh, {});
  std::vector<double> down(mesh.vertices.size(), 0);  // metres^2
  for (std::size_t t = 0; t < caps.triangles.size(); ++t) {
    const Points& at = mesh.vertices;
    const Eigen::Vector3i& corner = caps.triangles[t];
    const Eigen::Vector3d area = 0.5 * (at[corner[1]] - at[corner[0]]).cross(at[corner[2]] - at[corner[0]]);
    for (const int vertex : corner) down[vertex] -= caps.share[t] * area.z() / 3;
  }
  const std::vector<int>& rim = mesh.groups.at("base");
  const double count = static_cast<double>(rim.size());
  // Of a regular polygon.
  const double exact = 0.5 * count * 20e-3 * 20e-3 * std::sin(2 * std::numbers::pi / count);
  for (const int vertex : rim) EXPECT_NEAR(down[vertex], exact / count, 1e-12 * exact);
}

TEST(CapFans, EncloseTheSameWhenAnEdgeOfABentRimIsDivided) {
  SurfaceMesh whole = square({}), divided = square({{-0.004, -0.01, 0.005}});
  const CapSurface before = spread_caps(whole, {}), after = spread_caps(divided, {});
  // A vertex goes up: the one on the side goes by its part of the way, 0.3, along.
  whole.vertices[0].z() += 3e-3;
  divided.vertices[0].z() += 3e-3;
  divided.vertices[1].z() += 0.7 * 3e-3;
  const double volume = volume_below(before, whole.vertices);
  EXPECT_NEAR(volume_below(after, divided.vertices), volume, 1e-14 * volume);
}

TEST(CapFans, LeaveCapsAsTheyAreThatAreHeldAlongTheirNormal) {
  const SurfaceMesh mesh = make_cylinder(10e-3, 40e-3, 200);
  const std::vector<FixedRegion> both = {fixed_group("ends", {false, true, false})};
  const CapSurface held = spread_caps(mesh, both);
  EXPECT_EQ(held.triangles, mesh.cap_triangles);
  EXPECT_EQ(std::accumulate(held.share.begin(), held.share.end(), 0.0), static_cast<double>(held.share.size()));
  const std::vector<FixedRegion> one = {{.region = BelowRegion{.axis = 1, .at = -19e-3}}};
  EXPECT_GT(spread_caps(mesh, one).triangles.size(), mesh.cap_triangles.size());
}

TEST(CapFans, MeetAtCornersThatAreFreeUnlessBothAreHeldThere) {
  const SurfaceMesh pad = make_semicylinder(10e-3, 40e-3, 200);
  const FixedRegion base = fixed_group("base", {false, false, true}), ends = fixed_group("ends", {false, true, false});
  EXPECT_TRUE(has_free_corner(pad, {}));
  EXPECT_TRUE(has_free_corner(pad, std::vector{base}));
  EXPECT_FALSE(has_free_corner(pad, std::vector{base, ends}));
  EXPECT_FALSE(has_free_corner(pad, std::vector{fixed_group("base")}));
  EXPECT_FALSE(has_free_corner(make_cylinder(10e-3, 40e-3, 200), {})) << "its caps do not meet";
}

TEST(CapFans, HaveTheSlopesOfTheirVolumeAndOfTheWeightOnThem) {
  BodyDefinition definition = make_body(make_hemisphere(20e-3, 64), 1e-3, neo_hookean(20e3));
  definition.fixed = {{.region = AboveRegion{.axis = 2, .at = 15e-3}}};
  const BodyModel model = make_body_model(definition);
  EquilibriumProblem problem;
  problem.fluids.resize(1);
  problem.gravity = {1, -2, -9};
  problem.start = model.rest_position;
  const Eigen::VectorXd pressure = Eigen::VectorXd::Constant(1, 300);
  const auto wave = [](double size, double rate) {
    return [=](Eigen::Index k) { return size * std::sin(rate * static_cast<double>(k)); };
  };
  const Eigen::Index count = model.rest_position.size();
  const Eigen::VectorXd position = 1.1 * model.rest_position + Eigen::VectorXd::NullaryExpr(count, wave(1e-3, 3));
  Eigen::VectorXd way = Eigen::VectorXd::NullaryExpr(count, wave(1, 7));
  for (Eigen::Index k = 0; k < count; ++k) way[k] *= model.fixed[k] ? 0 : 1;
  EquilibriumTerms terms, ahead, behind;
  const double h = 1e-8;
  evaluate(model, problem, position, pressure, true, terms);
  evaluate(model, problem, position + h * way, pressure, true, ahead);
  evaluate(model, problem, position - h * way, pressure, true, behind);
  const double rise = (ahead.volume[0] - behind.volume[0]) / (2 * h);
  EXPECT_NEAR(terms.volume_gradient.col(0).dot(way), rise, 1e-7 * std::abs(rise));
  EXPECT_NEAR(enclosed_volumes(model, position)[0], terms.volume[0], 1e-14 * terms.volume[0]);
  const auto force = [&](const EquilibriumTerms& one) {
    return (one.gradient - one.volume_gradient * pressure).eval();
  };
  Eigen::VectorXd difference = (force(ahead) - force(behind)) / (2 * h), product;
  multiply(model.pattern, terms.values, way, product);
  for (Eigen::Index k = 0; k < count; ++k) difference[k] = model.fixed[k] ? product[k] : difference[k];
  EXPECT_LT((product - difference).cwiseAbs().maxCoeff(), 1e-6 * difference.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace thinwall
