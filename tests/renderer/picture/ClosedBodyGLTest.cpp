#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{64, 64};

/// From `place` on the x axis, metres, towards +x, before nothing but green.
Image seen_along_x(const SnapshotSurface& surface, double place, double field_of_view, Tier tier) {
  Snapshot snapshot;
  snapshot.surfaces = {surface};
  ViewDefinition view;
  view.camera.position = Double3{place, 0, 0};
  view.camera.target = Double3{place + 0.1, 0, 0};
  view.camera.field_of_view = field_of_view;
  view.look.floor = false;
  view.look.background = {0, 1, 0};
  return Renderer(DeviceChoice{}, kSize, tier).draw(snapshot, view);
}

/// Of a ball of 30 mm around the origin, seen from `place` on the x axis, metres, towards +x. Nothing else is there.
Image picture_from(double place, bool faces_inwards, Tier tier) {
  SnapshotSurface ball = test::sphere("organ", {0, 0, 0}, 0.03, 3);
  if (faces_inwards) {
    auto topology = std::make_shared<SnapshotTopology>(*ball.topology);
    for (Triangle& triangle : topology->triangles) std::swap(triangle[1], triangle[2]);
    ball.topology = topology;
  }
  return seen_along_x(ball, place, 0.3, tier);
}

/// Of such a ball that is open where x < -15 mm and has a cap instead of a wall where x > 15 mm, seen through the
/// opening.
Image picture_of_the_cap(Tier tier) {
  SnapshotSurface ball = test::sphere("organ", {0, 0, 0}, 0.03, 4);
  auto topology = std::make_shared<SnapshotTopology>(*ball.topology);
  topology->triangles.clear();
  for (const Triangle& triangle : ball.topology->triangles) {
    float x = 0;
    for (const std::uint32_t vertex : triangle) x += ball.positions[vertex][0] / 3;
    if (x > 0.015F) topology->cap_triangles.push_back(triangle);
    if (x > -0.015F && x <= 0.015F) topology->triangles.push_back(triangle);
  }
  topology->thickness.assign(topology->triangles.size(), 0.001F);
  ball.topology = topology;
  return seen_along_x(ball, -0.12, 0.15, tier);
}

/// Pixels, of all, that are as green as the background.
int background_of(const Image& image) {
  int count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    count += image.pixels[i + 1] > 200 && image.pixels[i] < 50 ? 1 : 0;
  }
  return count;
}

/// Triangles that face away are left out where others hide them; from within an organ they are all that is seen.
TEST(ClosedBody, IsSeenFromInsideAndOutside) {
  for (const Tier tier : {Tier::kDraft, Tier::kRecord, Tier::kFinal}) {
    EXPECT_EQ(background_of(picture_from(0, false, tier)), 0) << "from the middle";
    EXPECT_EQ(background_of(picture_from(-0.029, false, tier)), 0) << "from just behind the wall";
    EXPECT_EQ(background_of(picture_from(-0.09, false, tier)), 0) << "from outside, where it fills the picture";
  }
}

/// A dome that stands on a cap was black within, as what faces away from the viewer was left out.
TEST(ClosedBody, ShowsItsCapsFromWithinThroughAnOpening) {
  for (const Tier tier : {Tier::kDraft, Tier::kRecord}) {
    const Image image = picture_of_the_cap(tier);
    EXPECT_EQ(background_of(image), 0);
    const std::size_t middle = 3 * static_cast<std::size_t>(32 * kSize.width + 32);
    EXPECT_GT(image.pixels[middle], 1.3 * image.pixels[middle + 1]) << "red as the lining";
  }
}

/// The same ball, 2 mm thick and white outside, through an endoscope in its middle; mean of each channel over the
/// picture.
std::array<double, 3> color_within(Vector3 toward) {
  SnapshotSurface ball = test::sphere("organ", {0, 0, 0}, 0.03, 4);
  auto topology = std::make_shared<SnapshotTopology>(*ball.topology);
  topology->thickness.assign(topology->triangles.size(), 0.002F);
  ball.topology = topology;
  Snapshot snapshot;
  snapshot.surfaces = {ball};
  ViewDefinition view;
  view.camera = {.position = Double3{0.004, 0, 0},
                 .target = Double3{0.004 + toward.x, toward.y, toward.z},
                 .up = Double3{0, 1, 0},
                 .field_of_view = 0.6};
  view.lights.endoscope = 1;
  view.look.bodies["organ"] = {.color = {1, 1, 1}, .mottling = 0};
  const Image image = Renderer(DeviceChoice{}, kSize, Tier::kRecord).draw(snapshot, view);
  std::array<double, 3> mean{};
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    mean[i % 3] += image.pixels[i] / static_cast<double>(kSize.width * kSize.height);
  return mean;
}

/// As an endoscope in a stomach or a bladder shows it; the lamp's map looked away from what it saw.
TEST(ClosedBody, ShowsItsLitLiningFromWithinOnAllSides) {
  for (const Vector3 toward : {Vector3{1, 0, 0}, Vector3{-1, 0, 0}, Vector3{0, 0, 1}}) {
    const std::array<double, 3> color = color_within(toward);
    const std::string where = std::to_string(toward.x) + ' ' + std::to_string(toward.z);
    // Seen: 186 and more, and 1.19 to 1.6; of the white outside 1.00.
    EXPECT_GT(color[0], 150) << where;
    EXPECT_GT(color[0], 1.12 * color[1]) << where;
  }
}

/// Of a ball of 30 mm with a small hole on its nearest place, the rest of whose far side was pushed out beside the hole
/// towards the viewer, so that the wall crosses itself.
Image picture_of_a_crumpled_ball(Tier tier) {
  SnapshotSurface ball = test::sphere("organ", {0, 0, 0}, 0.03, 4);
  auto topology = std::make_shared<SnapshotTopology>(*ball.topology);
  std::erase_if(topology->triangles, [&](const Triangle& triangle) {
    return std::ranges::all_of(triangle, [&](std::uint32_t v) { return ball.positions[v][0] < -0.028F; });
  });
  topology->thickness.assign(topology->triangles.size(), 0.001F);
  ball.topology = topology;
  for (Float3& place : ball.positions) {
    if (place[0] > 0.02F && std::hypot(place[1] - 0.008F, place[2]) < 0.009F) place[0] = -0.04F;
  }
  return seen_along_x(ball, -0.12, 0.3, tier);
}

/// Triangles of its lining that lie beside the hole as well as behind it were counted as seen, and not shaded.
TEST(ClosedBody, HasNoHolesWhereItsWallCrossesItself) {
  for (const Tier tier : {Tier::kDraft, Tier::kRecord}) EXPECT_EQ(background_of(picture_of_a_crumpled_ball(tier)), 0);
}

TEST(ClosedBody, ThatFacesInwardsIsSeenAllTheSame) {
  EXPECT_EQ(background_of(picture_from(-0.09, true, Tier::kRecord)), 0);
  EXPECT_EQ(background_of(picture_from(0, true, Tier::kRecord)), 0);
}

}  // namespace
}  // namespace thinwall
