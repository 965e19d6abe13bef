#include "engine/simulation/CutTransfer.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "engine/cutting/CutSurface.hpp"
#include "tests/engine/simulation/CutSheets.hpp"

namespace thinwall {
namespace {

/// A symmetric tensor in space as it is told in the axes of a triangle: (11, 22, `shear` 12).
Eigen::Vector3d told_in(const BodyModel& model, int triangle, const Eigen::Matrix3d& tensor, double shear) {
  const auto corners = corners_of(model.surface[triangle], model.rest_position);
  Eigen::Matrix<double, 3, 2> edges;
  edges << corners[1] - corners[0], corners[2] - corners[0];
  const Eigen::Matrix<double, 3, 2> axes = edges * model.rest[triangle].inverse_edges;
  const Eigen::Matrix2d told = axes.transpose() * tensor * axes;
  return {told(0, 0), told(1, 1), shear * told(0, 1)};
}

TEST(ACutThroughAViscousWall, LeavesEachPlaceWhatItRemembersInTheAxesOfItsNewTriangle) {
  BodyDefinition definition = stretched_sheet(200, 1);
  Body body(definition, {}, {});
  body.settle();
  const BodyModel& before = body.model();
  Eigen::Matrix3d even = Eigen::Matrix3d::Zero();
  even.topLeftCorner<2, 2>() << 3, 0.7, 0.7, -1;
  const auto told = [&](const BodyModel& model, double shear) {
    std::vector<Eigen::Vector3d> field;
    for (int t = 0; t < model.triangles(); ++t) field.push_back(told_in(model, t, even, shear));
    return field;
  };
  BodyState state = body.state();
  state.wall.branch_stress = state.wall.branch_moment = {told(before, 1)};
  state.wall.overstress = state.wall.overmoment = told(before, 1);
  state.wall.previous_strain = state.wall.previous_bending_strain = told(before, 2);
  CutSurface surface(before.definition.mesh);
  const Cut cut = surface.cut(path_between(body, {-7e-3, -2e-3, 1e-3}, {8e-3, 3e-3, 1e-3}));
  ASSERT_GT(cut.triangles.size(), 10U);
  const BodyModel after = make_body_model(cut_definition(before, surface, cut));
  const WallHistory wall = carried_over(before, state, after, cut, Eigen::Vector3d::Zero()).wall;
  const std::vector<Eigen::Vector3d> stress = told(after, 1), strain = told(after, 2);
  for (const auto& [carried, expected] :
       {std::pair(&wall.branch_stress[0], &stress), std::pair(&wall.branch_moment[0], &stress),
        std::pair(&wall.overstress, &stress), std::pair(&wall.overmoment, &stress),
        std::pair(&wall.previous_strain, &strain), std::pair(&wall.previous_bending_strain, &strain)}) {
    ASSERT_EQ(carried->size(), expected->size());
    for (std::size_t t = 0; t < expected->size(); ++t) {
      EXPECT_LT(((*carried)[t] - (*expected)[t]).norm(), 1e-12) << t;
    }
  }
}

TEST(ACutThroughAnUnevenWall, LeavesItsMass) {
  BodyDefinition definition = stretched_sheet(200, 1);
  const SurfaceMesh& mesh = definition.mesh;
  const auto middle_of = [](const SurfaceMesh& of, std::size_t t) -> Eigen::Vector3d {
    const Eigen::Vector3i& v = of.triangles[t];
    return (of.vertices[v[0]] + of.vertices[v[1]] + of.vertices[v[2]]) / 3;
  };
  const std::size_t triangles = mesh.triangles.size();
  definition.thickness.resize(triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    const Eigen::Vector3d middle = middle_of(mesh, t);
    definition.thickness[t] = 1e-3 + 0.01 * middle.x();
  }
  const BodyModel before = make_body_model(definition);
  const Body even(stretched_sheet(200, 1), {}, {});
  CutSurface surface(before.definition.mesh);
  const Cut cut = surface.cut(path_between(even, {-7e-3, -9e-3, 1e-3}, {8e-3, 9e-3, 1e-3}));
  const BodyDefinition after = cut_definition(before, surface, cut);
  const auto volume = [](const BodyDefinition& of) {
    double sum = 0;
    for (std::size_t t = 0; t < of.mesh.triangles.size(); ++t) {
      const Eigen::Vector3i& v = of.mesh.triangles[t];
      const Eigen::Vector3d &a = of.mesh.vertices[v[0]], &b = of.mesh.vertices[v[1]], &c = of.mesh.vertices[v[2]];
      sum += of.thickness[t] * 0.5 * (b - a).cross(c - a).norm();
    }
    return sum;
  };
  EXPECT_NEAR(volume(after), volume(definition), 1e-12 * volume(definition));
}

}  // namespace
}  // namespace thinwall
