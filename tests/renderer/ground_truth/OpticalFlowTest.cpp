#include "renderer/ground_truth/OpticalFlow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "renderer/ground_truth/GroundTruth.hpp"
#include "tests/renderer/ground_truth/RayCast.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kFlowSize = {.width = 160, .height = 90};

ViewDefinition from_above(double height) {
  ViewDefinition view;
  view.camera.position = Double3{0, 0, height};
  view.camera.target = Double3{0, 0, 0};
  view.camera.up = Double3{0, 1, 0};
  return view;
}

int count(const OpticalFlow& flow, FlowState state) {
  return static_cast<int>(std::ranges::count(flow.state, state));
}

/// A sheet of 40 mm in z = 0, `columns` by `rows` squares, moved by `motion`. A cut along x = 0 doubles the vertices
/// there but for the outermost two, with even `columns` only; of a doubled vertex the first belongs to the left.
SnapshotSurface sheet(int columns, int rows, bool is_cut, const std::function<Vector3(Vector3, bool)>& motion) {
  auto topology = std::make_shared<SnapshotTopology>();
  const auto vertex = [&](int column, int row) { return static_cast<std::uint32_t>(row * (columns + 1) + column); };
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      topology->rest_positions.push_back(
          {static_cast<float>(0.04 * column / columns - 0.02), static_cast<float>(0.04 * row / rows - 0.02), 0});
    }
  }
  std::vector<std::uint32_t> right_of(topology->rest_positions.size());
  for (std::uint32_t v = 0; v < right_of.size(); ++v) right_of[v] = v;
  for (int row = 1; is_cut && row < rows; ++row) {
    const std::uint32_t left = vertex(columns / 2, row);
    right_of[left] = static_cast<std::uint32_t>(topology->rest_positions.size());
    topology->rest_positions.push_back(topology->rest_positions[left]);
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      std::uint32_t a = vertex(column, row), b = vertex(column + 1, row);
      std::uint32_t c = vertex(column + 1, row + 1), d = vertex(column, row + 1);
      if (column >= columns / 2) {
        for (std::uint32_t* corner : {&a, &b, &c, &d}) *corner = right_of[*corner];
      }
      topology->triangles.push_back({a, b, c});
      topology->triangles.push_back({a, c, d});
    }
  }
  topology->thickness.assign(topology->triangles.size(), 0.001F);
  SnapshotSurface surface{.body = "sheet", .topology = topology, .positions = {}, .fields = {}};
  for (std::uint32_t v = 0; v < topology->rest_positions.size(); ++v) {
    const bool is_right = v >= right_of.size() || topology->rest_positions[v][0] > 1e-6F;
    const Vector3 place = motion(vector3(topology->rest_positions[v]), is_right);
    surface.positions.push_back(
        {static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)});
  }
  return surface;
}

TEST(OpticalFlowTest, LeadsToWhereTheMatterLandsBesideAMovingCamera) {
  Snapshot before, after;
  before.surfaces = {test::sphere("ball", {0, 0, 0}, 0.02, 3)};
  before.tools = {{.name = "probe", .kind = SnapshotToolKind::kSphere, .radius = 0.006, .tip = {0, -0.012, 0.016}}};
  after = before;
  after.time = 0.04;
  after.tools[0].tip = {0.001, -0.013, 0.013};
  for (Float3& p : after.surfaces[0].positions) {
    p = {p[0] * 1.1F, p[1] + 2 * p[0] * p[0], p[2] - 0.2F * std::abs(p[2])};
  }
  ViewDefinition view;
  view.camera.orbit_speed = 1.5;
  const SeenFrame first(before, {view.camera}, kFlowSize), second(after, {view.camera}, kFlowSize);
  const OpticalFlow flow = optical_flow(first.moment(), second.moment());
  const double scene_size = scene_extent(before).size;
  double largest = 0, longest = 0;
  int checked = 0;
  for (int row = 0; row < kFlowSize.height; row += 3) {
    for (int column = 0; column < kFlowSize.width; column += 3) {
      const auto hit = test::cast(before, first.camera(), kFlowSize, scene_size, column, row);
      const std::size_t pixel = static_cast<std::size_t>(row * kFlowSize.width + column);
      EXPECT_EQ(hit.has_value(), flow.state[pixel] != FlowState::kNothing);
      if (!hit) continue;
      Vector3 place;
      const ToolShape shape = tool_shape(after.tools[0], scene_size);
      for (std::size_t k = 0; k < 3; ++k) {
        const Float3 corner = hit->owner == 0
                                  ? after.surfaces[0].positions[after.surfaces[0].topology->triangles[hit->triangle][k]]
                                  : shape.vertices[shape.indices[3 * hit->triangle + k]].position;
        place = place + hit->weights[k] * vector3(corner);
      }
      const auto landed = *second.camera().pixel(place, kFlowSize);
      const auto [u, v] = flow.flow[pixel];
      largest = std::max({largest, std::abs(landed[0] - (column + 0.5) - u), std::abs(landed[1] - (row + 0.5) - v)});
      longest = std::max(longest, static_cast<double>(std::hypot(u, v)));
      ++checked;
    }
  }
  EXPECT_GT(checked, 200);
  EXPECT_GT(longest, 3);
  // Rounding to floats of some pixels.
  EXPECT_LT(largest, 1e-5);
}

/// `straight`: metres from the middle of the cut, up to where its lips are drawn straight.
void expect_exact_across_the_cut(DrawnEdges edges, double straight) {
  const auto still = [](Vector3 p, bool) { return p; };
  const double gap = 0.003;
  // Linear on either side, so that triangles of any size carry it without error; nothing at the tips of the cut.
  const auto opened = [&](Vector3 p, bool is_right) {
    return p + Vector3{(is_right ? gap : -gap) + 0.1 * p.x, 0.05 * p.x, 0};
  };
  Snapshot before, after;
  before.surfaces = {sheet(6, 4, false, still)};
  after.surfaces = {sheet(10, 6, true, opened)};
  const ViewDefinition view = from_above(0.1);
  const SeenFrame first(before, {view.camera}, kFlowSize, edges), second(after, {view.camera}, kFlowSize, edges);
  const OpticalFlow forward = optical_flow(first.moment(), second.moment());
  const OpticalFlow backward = optical_flow(second.moment(), first.moment());
  int seen = 0;
  for (std::size_t pixel = 0; pixel < forward.state.size(); ++pixel) {
    if (forward.state[pixel] != FlowState::kSeen) continue;
    const auto& ray = *first.moment().projection.rays()[pixel];
    const Vector3 place{0.1 * ray[0], -0.1 * ray[1], 0};
    // The rows at the sheet's ends hold the tips of the cut, where both sides still meet.
    if (std::abs(place.y) > straight || std::abs(place.x) < 1e-5) continue;
    const Vector3 motion = opened(place, place.x > 0) - place;
    const double pixels_per_metre = 0.5 * kFlowSize.height / (0.1 * first.camera().tangent_y);
    ASSERT_NEAR(forward.flow[pixel][0], pixels_per_metre * motion.x, 0.002) << place.x << " " << place.y;
    ASSERT_NEAR(forward.flow[pixel][1], -pixels_per_metre * motion.y, 0.002) << place.x << " " << place.y;
    ++seen;
  }
  EXPECT_GT(seen, 200);
  // What the cut has laid open was not there before: its faces, and nothing of the outside.
  const GroundTruth truth = ground_truth(second);
  int born = 0;
  for (std::size_t pixel = 0; pixel < backward.state.size(); ++pixel) {
    const bool is_face = truth.wound[pixel] == WoundPart::kCutFace;
    EXPECT_EQ(backward.state[pixel] == FlowState::kAbsent, is_face) << pixel;
    born += is_face;
  }
  EXPECT_GT(born, 2);
}

TEST(OpticalFlowTest, IsExactAcrossACutThatHasMeshedTheSheetAnew) {
  expect_exact_across_the_cut(DrawnEdges::kStraight, 0.0133);
  // A curve leaves the edges beside those that end at the tips.
  expect_exact_across_the_cut(DrawnEdges::kCurvedLips, 0.0066);
}

TEST(OpticalFlowTest, FacesOfACutKeepTheirPlacesWhenTheCutGoesOn) {
  const auto opened = [](double gap) {
    return [gap](Vector3 p, bool is_right) { return p + Vector3{is_right ? gap : -gap, 0, is_right ? 0.0 : 0.004}; };
  };
  Snapshot before, after;
  before.surfaces = {sheet(6, 24, true, opened(0.002))};
  after.surfaces = {sheet(6, 28, true, opened(0.003))};
  ViewDefinition view = from_above(0.1);
  view.camera.position = Double3{0.05, 0, 0.08};
  const SeenFrame first(before, {view.camera}, kFlowSize), second(after, {view.camera}, kFlowSize);
  const OpticalFlow flow = optical_flow(first.moment(), second.moment());
  const GroundTruth truth = ground_truth(first);
  int faces = 0;
  for (std::size_t pixel = 0; pixel < truth.wound.size(); ++pixel) {
    if (truth.wound[pixel] != WoundPart::kCutFace) continue;
    const auto& ray = *first.moment().projection.rays()[pixel];
    const Camera& camera = first.camera();
    const double depth = truth.depth[pixel];
    const Vector3 place = camera.position + depth * (camera.forward + ray[0] * camera.right - ray[1] * camera.up);
    // The left face is what the camera on the right sees of the cut. Away from its tips, near which the way through the
    // wall turns, all of it moves by 1 mm.
    if (std::abs(place.y) > 0.005) continue;
    const auto landed = *second.camera().pixel(place + Vector3{-0.001, 0, 0}, kFlowSize);
    const auto column = static_cast<double>(pixel % 160), row = static_cast<double>(pixel / 160);
    EXPECT_NEAR(flow.flow[pixel][0], landed[0] - column - 0.5, 0.002);
    EXPECT_NEAR(flow.flow[pixel][1], landed[1] - row - 0.5, 0.002);
    ++faces;
  }
  EXPECT_GT(faces, 20);
}

TEST(OpticalFlowTest, TellsWhatIsHiddenAndWhatLeavesThePicture) {
  const auto square = [](const std::string& body, float x, float z, float half) {
    return test::quad(body, {{{x - half, -half, z}, {x + half, -half, z}, {x + half, half, z}, {x - half, half, z}}});
  };
  Snapshot before, after;
  before.surfaces = {square("back", 0, 0, 0.02F), square("front", 0.04F, 0.001F, 0.005F)};
  after = before;
  for (Float3& p : after.surfaces[1].positions) p[0] -= 0.04F;
  const ViewDefinition view = from_above(0.15);
  const SeenFrame first(before, {view.camera}, kFlowSize), second(after, {view.camera}, kFlowSize);
  const OpticalFlow forward = optical_flow(first.moment(), second.moment());
  const OpticalFlow backward = optical_flow(second.moment(), first.moment());
  const double half_picture = 0.15 * first.camera().tangent_y;
  const double pixels = std::pow(0.01 * 0.5 * kFlowSize.height / half_picture * 0.15 / 0.149, 2);
  // What the front square comes to lie before; a row of pixels around it is open.
  EXPECT_NEAR(count(forward, FlowState::kHidden), pixels, 4 * std::sqrt(pixels));
  EXPECT_EQ(count(backward, FlowState::kHidden), 0);
  EXPECT_EQ(count(forward, FlowState::kOutside), 0);
  for (Float3& p : after.surfaces[1].positions) p[0] += 1;
  const SeenFrame third(after, {view.camera}, kFlowSize);
  const OpticalFlow leaving = optical_flow(first.moment(), third.moment());
  EXPECT_EQ(count(leaving, FlowState::kOutside), std::ranges::count(ground_truth(first).instances, 2));
}

TEST(OpticalFlowTest, WhatLandsNowhereHasNoFlowThatIsKnown) {
  Snapshot snapshot;
  snapshot.surfaces = {
      test::quad("wall", {{{-0.02F, -0.02F, 0}, {0.02F, -0.02F, 0}, {0.02F, 0.02F, 0}, {-0.02F, 0.02F, 0}}})};
  const SeenFrame first(snapshot, {from_above(0.1).camera}, kFlowSize);
  ViewDefinition turned_away = from_above(0.1), aside = from_above(0.1);
  turned_away.camera.target = Double3{0, 0, 1};
  aside.camera.position = Double3{1, 0, 0.1};
  aside.camera.target = Double3{1, 0, 0};
  const OpticalFlow behind =
      optical_flow(first.moment(), SeenFrame(snapshot, {turned_away.camera}, kFlowSize).moment());
  const OpticalFlow beside = optical_flow(first.moment(), SeenFrame(snapshot, {aside.camera}, kFlowSize).moment());
  int seen = 0;
  for (std::size_t pixel = 0; pixel < behind.state.size(); ++pixel) {
    if (first.seen().places[pixel].triangle == kNoIndex) continue;
    ++seen;
    EXPECT_EQ(behind.state[pixel], FlowState::kOutside);
    EXPECT_FALSE(behind.is_known[pixel]) << "no pixel shows what lies behind a camera";
    EXPECT_EQ(beside.state[pixel], FlowState::kOutside);
    EXPECT_TRUE(beside.is_known[pixel]);
    EXPECT_LT(beside.flow[pixel][0], -kFlowSize.width);
  }
  EXPECT_GT(seen, 1000);
}

TEST(OpticalFlowTest, WhatIsNearerThanACameraSeesLiesOutsideItsPicture) {
  Snapshot snapshot;
  snapshot.surfaces = {
      test::quad("wall", {{{-0.02F, -0.02F, 0}, {0.02F, -0.02F, 0}, {0.02F, 0.02F, 0}, {-0.02F, 0.02F, 0}}})};
  const double nearest = 1e-3 * scene_extent(snapshot).size;  // of cameras that are nearer to what they look at
  const SeenFrame first(snapshot, {from_above(1.1 * nearest).camera}, kFlowSize);
  const SeenFrame close(snapshot, {from_above(0.9 * nearest).camera}, kFlowSize);
  const OpticalFlow flow = optical_flow(first.moment(), close.moment());
  EXPECT_EQ(count(flow, FlowState::kOutside), kFlowSize.width * kFlowSize.height);
  const std::size_t middle = static_cast<std::size_t>(kFlowSize.height / 2 * kFlowSize.width + kFlowSize.width / 2);
  EXPECT_TRUE(flow.is_known[middle]);
  EXPECT_NEAR(flow.flow[middle][0], 0.5 * (1.1 / 0.9 - 1), 1e-3) << "where it lands all the same";
}

TEST(OpticalFlowTest, TheInnerSideOfAWholeWallIsHiddenFromOutsideAndNotBornOfACut) {
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("ball", {0, 0, 0}, 0.03, 4)};
  auto topology = std::make_shared<SnapshotTopology>(*snapshot.surfaces[0].topology);
  topology->thickness.assign(topology->triangles.size(), 0.002F);
  snapshot.surfaces[0].topology = topology;
  ViewDefinition within;
  within.camera = {
      .position = Double3{0, 0, 0}, .target = Double3{0, 1, 0}, .up = Double3{0, 0, 1}, .field_of_view = 0.8};
  ViewDefinition outside = within;
  outside.camera.position = Double3{0, -0.2, 0};
  const SeenFrame first(snapshot, {within.camera}, kFlowSize), second(snapshot, {outside.camera}, kFlowSize);
  const OpticalFlow flow = optical_flow(first.moment(), second.moment());
  for (std::size_t pixel = 0; pixel < flow.state.size(); ++pixel) {
    ASSERT_EQ(flow.state[pixel], FlowState::kHidden) << pixel;
    // Both cameras look along the same line, so that what lies off it by a tangent is seen smaller by its distances.
    const auto& ray = *first.moment().projection.rays()[pixel];
    const double depth = first.seen().depth[pixel];
    // Positions are floats, whose rounding is a millionth of the distance to the pixels seen from within.
    const double shrunk = depth / (depth + 0.2), focal = 0.5 * kFlowSize.height / first.camera().tangent_y;
    ASSERT_NEAR(flow.flow[pixel][0], focal * ray[0] * (shrunk - 1), 1e-3);
    ASSERT_NEAR(flow.flow[pixel][1], focal * ray[1] * (shrunk - 1), 1e-3);
  }
}

TEST(OpticalFlowTest, TheInnerSideOfAThinWholeWallIsHiddenThoughNothingLiesBeforeIt) {
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("ball", {0, 0, 0}, 0.03, 4)};
  auto topology = std::make_shared<SnapshotTopology>(*snapshot.surfaces[0].topology);
  // More than positions are rounded by, and less than a place must lie behind another one to be hidden by it.
  topology->thickness.assign(topology->triangles.size(), 5e-8F);
  snapshot.surfaces[0].topology = topology;
  ViewDefinition within, outside;
  within.camera = {
      .position = Double3{0, 0, 0}, .target = Double3{0, -1, 0}, .up = Double3{0, 0, 1}, .field_of_view = 0.8};
  outside.camera = within.camera;
  outside.camera.position = Double3{0, -0.2, 0};
  outside.camera.target = Double3{0, 1, 0};
  const SeenFrame first(snapshot, {within.camera}, kFlowSize), second(snapshot, {outside.camera}, kFlowSize);
  const OpticalFlow flow = optical_flow(first.moment(), second.moment());
  EXPECT_EQ(count(flow, FlowState::kHidden), kFlowSize.width * kFlowSize.height);
}

}  // namespace
}  // namespace thinwall
