#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "engine/mesh/Shapes.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// Where the wall is after a sphere has pressed it.
Eigen::VectorXd pressed(int triangles) {
  Body body(pressurised_hemisphere(triangles, 500), {sphere_tool(0.005)}, quasi_static());
  body.settle();
  move(body, pose_at({0, 0, 0.021}), {0.002, 0, 0.017}, 4, 0.01);
  return body.state().equilibrium.position;
}

TEST(ManyBodiesTest, BodiesInThreadsOfTheirOwnAreSolvedAsAlone) {
  const std::vector<int> sizes = {256, 1024, 256, 576};
  std::vector<Eigen::VectorXd> alone, together(sizes.size());
  for (const int triangles : sizes) alone.push_back(pressed(triangles));
  for (int turn = 0; turn < 4; ++turn) {
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      threads.emplace_back([&, k] { together[k] = pressed(sizes[k]); });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t k = 0; k < sizes.size(); ++k) EXPECT_EQ(together[k], alone[k]) << k;
  }
}

}  // namespace
}  // namespace thinwall
