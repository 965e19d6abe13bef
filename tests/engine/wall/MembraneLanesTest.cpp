#include "engine/wall/MembraneLanes.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engine/wall/TensionField.hpp"

namespace thinwall {
namespace {

/// Unlike each other in shape, law, strain and memory: taut, wrinkled, slack and viscous.
class UnlikeTriangles {
 public:
  UnlikeTriangles() {
    const std::array<Eigen::Vector3d, 3> rest = {Eigen::Vector3d(0, 0, 0), {3e-3, 0.5e-3, 1e-3}, {0.5e-3, 4e-3, -1e-3}};
    const std::array<Eigen::Vector3d, kLanes> stretches = {
        Eigen::Vector3d(1.3, 1.2, 1.1), {1.4, 0.6, 1}, {0.7, 0.8, 0.9}, {1.05, 0.98, 1.2}};
    for (int k = 0; k < kLanes; ++k) {
      rests_.push_back(make_membrane_rest(rest, 1e-3 * (k + 1)));
      MembraneTriangle triangle;
      for (int corner = 0; corner < 3; ++corner) triangle.corners[corner] = stretches[k].cwiseProduct(rest[corner]);
      triangle.memory.tension_field = k == 1 || k == 2;
      triangle.memory.slack_stiffness = kSlackStiffness;
      triangles_.push_back(triangle);
    }
    triangles_[3].memory.scale = 0.8;
    triangles_[3].memory.damping = 0.1;
    triangles_[3].memory.overstress = {100, -50, 20};
    for (int k = 0; k < kLanes; ++k) {
      triangles_[k].rest = &rests_[k];
      triangles_[k].material = &materials_[k % 2];
    }
  }

  const std::vector<MembraneTriangle>& all() const { return triangles_; }

 private:
  std::vector<Material> materials_ = {{find_wall_law("neo_hookean"), {20e3}},
                                      {find_wall_law("mooney_rivlin"), {8e3, 2e3}}};
  std::vector<MembraneRest> rests_;
  std::vector<MembraneTriangle> triangles_;
};

TEST(MembraneLanes, ATriangleGetsTheSameBesideOthersAsAlone) {
  const UnlikeTriangles unlike;
  for (std::size_t count = 1; count <= unlike.all().size(); ++count) {
    MembraneLanes lanes;
    membrane_lanes(std::span(unlike.all()).first(count), true, lanes);
    for (std::size_t k = 0; k < count; ++k) {
      const MembraneTriangle& triangle = unlike.all()[k];
      const MembraneTerms alone = membrane_terms(*triangle.rest, *triangle.material, triangle.corners, triangle.memory);
      EXPECT_EQ(lanes.energy[k], alone.energy);
      EXPECT_EQ(lanes.strain_energy[k], alone.strain_energy);
      EXPECT_EQ(lanes.largest_force[k], alone.gradient.cwiseAbs().maxCoeff());
      for (int i = 0; i < 9; ++i) EXPECT_EQ(lanes.gradient[i][k], alone.gradient[i]);
      // The last block, (0, 2), whole.
      for (int i = 0; i < 9; ++i) EXPECT_EQ(lanes.hessian[5][i][k], alone.hessian(i % 3, 6 + i / 3));
    }
  }
}

TEST(MembraneLanes, ForcesAreTheSameWithoutTheHessian) {
  const UnlikeTriangles unlike;
  MembraneLanes whole, forces;
  for (auto& block : forces.hessian) block.fill(OfLanes{});
  membrane_lanes(unlike.all(), true, whole);
  membrane_lanes(unlike.all(), false, forces);
  EXPECT_EQ(forces.energy, whole.energy);
  EXPECT_EQ(forces.gradient, whole.gradient);
  EXPECT_EQ(forces.largest_force, whole.largest_force);
  for (const auto& block : forces.hessian) EXPECT_EQ(block[0], OfLanes{});
}

TEST(MembraneLanes, ATriangleThatMovesAsAWholeBearsNoForce) {
  const UnlikeTriangles unlike;
  Eigen::Matrix<double, 9, 3> shift;
  shift << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity();
  for (const MembraneTriangle& triangle : unlike.all()) {
    const MembraneTerms terms = membrane_terms(*triangle.rest, *triangle.material, triangle.corners, triangle.memory);
    // Round-off of three blocks; 2e-16 is what is seen.
    EXPECT_LT((terms.hessian * shift).cwiseAbs().maxCoeff(), 1e-14 * terms.hessian.cwiseAbs().maxCoeff());
  }
}

}  // namespace
}  // namespace thinwall
