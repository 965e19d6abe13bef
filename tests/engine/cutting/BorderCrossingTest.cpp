#include "engine/cutting/BorderCrossing.hpp"

#include <gtest/gtest.h>

#include "engine/mesh/Shapes.hpp"

namespace thinwall {
namespace {

const Eigen::Vector3d kDown = -Eigen::Vector3d::UnitZ();

/// Two sheets of 2 by 1 side by side, 0.4 apart along y around zero, as one surface.
struct Halves {
  SurfaceMesh mesh = make_sheet(2, 1, 100);
  Eigen::VectorXd position;
  Halves() {
    const SurfaceMesh half = mesh;
    const int count = static_cast<int>(half.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), half.vertices.begin(), half.vertices.end());
    for (const Eigen::Vector3i& t : half.triangles) mesh.triangles.push_back(t.array() + count);
    position.resize(6 * count);
    for (int v = 0; v < 2 * count; ++v) {
      position.segment<3>(3 * v) = mesh.vertices[static_cast<std::size_t>(v)];
      position[3 * v + 1] += v < count ? -size() : size();
    }
  }
  static double size() { return 0.7; }
  SurfaceView view() const { return {.triangles = mesh.triangles, .position = position, .open = true}; }
  Eigen::Vector3d at(const SurfacePoint& point) const {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    const Eigen::Vector3i& corners = mesh.triangles[static_cast<std::size_t>(point.triangle)];
    for (int k = 0; k < 3; ++k) place += point.weights[k] * position.segment<3>(3 * corners[k]);
    return place;
  }
};

TEST(BorderCrossing, FindsTheNearAndTheFarBorderOfAGap) {
  const Halves halves;
  double extent = 0;  // of a half along y
  for (const Eigen::Vector3d& vertex : halves.mesh.vertices) extent = std::max(extent, vertex.y());
  const double gap = Halves::size() - extent;
  ASSERT_GT(gap, 0.1);
  const Eigen::Vector3d from(0.1, -gap - 0.3, 0), to(0.2, gap + 0.25, 0.02);
  const auto first = border_crossing(halves.view(), from, to, kDown, Crossing::kFirst);
  const auto last = border_crossing(halves.view(), from, to, kDown, Crossing::kLast);
  ASSERT_TRUE(first && last);
  EXPECT_NEAR(halves.at(*first).y(), -gap, 1e-12);
  EXPECT_NEAR(halves.at(*last).y(), gap, 1e-12);
  EXPECT_NEAR(halves.at(*first).x(), 0.1 + 0.1 * 0.3 / (0.55 + 2 * gap), 1e-12);
  // From the near border itself only the far one counts, and none backwards.
  EXPECT_NEAR(halves.at(*border_crossing(halves.view(), halves.at(*first), to, kDown, Crossing::kFirst)).y(), gap,
              1e-12);
  EXPECT_FALSE(border_crossing(halves.view(), from, {0.1, -gap - 0.4, 0}, kDown, Crossing::kFirst));
}

}  // namespace
}  // namespace thinwall
