#include "renderer/ground_truth/GroundTruth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/snapshot/SurfaceFields.hpp"
#include "tests/renderer/ground_truth/RayCast.hpp"
#include "tests/renderer/shape/CutSheets.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize = {.width = 160, .height = 90};

/// Two balls, one before the other, and a tool.
Snapshot scene() {
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("near", {0, -0.02, 0}, 0.02, 3), test::sphere("far", {0.02, 0.02, 0}, 0.03, 2)};
  snapshot.tools = {
      {.name = "ball", .kind = SnapshotToolKind::kSphere, .radius = 0.006, .tip = {-0.015, -0.03, 0.018}}};
  return snapshot;
}

/// A square of 40 mm in z = 0 whose border is no cut, and a hole in its middle that a cut has made: two triangles are
/// parted from each other along x = 0.
SnapshotSurface cut_square(double gap) {
  auto topology = std::make_shared<SnapshotTopology>();
  topology->rest_positions = {{-0.02F, -0.02F, 0}, {0, -0.02F, 0},    {0.02F, -0.02F, 0}, {-0.02F, 0.02F, 0},
                              {0, 0.02F, 0},       {0.02F, 0.02F, 0}, {0, -0.02F, 0},     {0, 0.02F, 0}};
  topology->triangles = {{0, 1, 4}, {0, 4, 3}, {6, 2, 5}, {6, 5, 7}};
  topology->thickness.assign(4, 0.002F);
  std::vector<Float3> positions = topology->rest_positions;
  for (const std::size_t v : {2U, 5U, 6U, 7U}) positions[v][0] += static_cast<float>(gap);
  return {.body = "square", .topology = topology, .positions = positions, .fields = {}};
}

TEST(GroundTruthTest, DepthIsThatOfRaysCastAtEveryTriangle) {
  for (const CameraKind kind : {CameraKind::kPinhole, CameraKind::kEndoscope}) {
    ViewDefinition view;
    view.camera.kind = kind;
    const Snapshot snapshot = scene();
    const SeenFrame frame(snapshot, {view.camera}, kSize);
    const GroundTruth truth = ground_truth(frame);
    const double scene_size = scene_extent(snapshot).size;
    double largest = 0;
    int seen = 0;
    for (int row = 0; row < kSize.height; row += 3) {
      for (int column = 0; column < kSize.width; column += 3) {
        const std::size_t pixel = static_cast<std::size_t>(row * kSize.width + column);
        if (!frame.moment().projection.rays()[pixel]) continue;
        const auto hit = test::cast(snapshot, frame.camera(), kSize, scene_size, column, row);
        ASSERT_EQ(hit ? 1 + hit->owner : 0, truth.instances[pixel]) << column << " " << row;
        if (!hit) {
          EXPECT_EQ(truth.depth[pixel], 0);
          continue;
        }
        ++seen;
        largest = std::max(largest, std::abs(truth.depth[pixel] - hit->depth) / hit->depth);
      }
    }
    EXPECT_GT(seen, 300);
    // Doubles rounded to floats: half of 2^-23.
    EXPECT_LT(largest, 1e-7);
  }
}

TEST(GroundTruthTest, EveryPixelIsOneInstanceWithItsPart) {
  const SeenFrame frame(scene(), {}, kSize);
  const GroundTruth truth = ground_truth(frame);
  std::array<int, 4> counts{};
  for (std::size_t pixel = 0; pixel < truth.instances.size(); ++pixel) {
    ASSERT_LE(truth.instances[pixel], 3);
    ++counts[truth.instances[pixel]];
    if (truth.instances[pixel] == 0) {
      EXPECT_EQ(truth.parts[pixel], 0);
      continue;
    }
    const PartKind kind = truth.instances[pixel] == 3 ? PartKind::kTool : PartKind::kOutside;
    EXPECT_EQ(truth.parts[pixel], kPartKinds * (truth.instances[pixel] - 1) + 1 + static_cast<int>(kind));
  }
  for (const int count : counts) EXPECT_GT(count, 20);
}

TEST(GroundTruthTest, NormalsOfABallLeadFromItsMiddleAndToTheViewer) {
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("ball", {0, 0, 0}, 0.02, 4)};
  const SeenFrame frame(snapshot, {}, kSize);
  const GroundTruth truth = ground_truth(frame);
  const Camera& camera = frame.camera();
  const Vector3 middle = frame.moment().projection.in_camera({0, 0, 0});
  double worst = 1;
  for (std::size_t pixel = 0; pixel < truth.depth.size(); ++pixel) {
    if (truth.instances[pixel] == 0) continue;
    const auto& ray = *frame.moment().projection.rays()[pixel];
    const double depth = truth.depth[pixel];
    const Vector3 outward = normalized(Vector3{ray[0] * depth, ray[1] * depth, depth} - middle);
    worst = std::min(worst, dot(outward, vector3(truth.normals[pixel])));
    EXPECT_NEAR(length(vector3(truth.normals[pixel])), 1, 1e-6);
  }
  // Interpolated over triangles of 4 degrees.
  EXPECT_GT(worst, std::cos(0.03));
  EXPECT_GT(camera.tangent_x, 0);
}

TEST(GroundTruthTest, NoNormalOfACoarseBallLeadsAwayFromTheViewer) {
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("ball", {0, 0, 0}, 0.02, 1)};
  const SeenFrame frame(snapshot, {}, kSize, DrawnEdges::kStraight);
  const GroundTruth truth = ground_truth(frame);
  int on_outline = 0;
  for (std::size_t pixel = 0; pixel < truth.depth.size(); ++pixel) {
    if (truth.instances[pixel] == 0) continue;
    const auto& ray = *frame.moment().projection.rays()[pixel];
    const double away = dot(normalized(Vector3{ray[0], ray[1], 1}), vector3(truth.normals[pixel]));
    EXPECT_LT(away, 1e-7) << pixel;
    if (away > -1e-7) ++on_outline;
  }
  EXPECT_GT(on_outline, 10) << "the triangles are coarse enough that some would";
}

TEST(GroundTruthTest, NothingIsSeenOutsideTheFieldStopOfAnEndoscope) {
  ViewDefinition view;
  view.camera.kind = CameraKind::kEndoscope;
  Snapshot snapshot;
  snapshot.surfaces = {test::quad("wall", {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}})};
  view.camera.position = Double3{0, 0, 0.1};
  view.camera.target = Double3{0, 0, 0};
  const GroundTruth truth = ground_truth(SeenFrame(snapshot, {view.camera}, kSize));
  EXPECT_EQ(truth.instances.front(), 0);
  EXPECT_EQ(truth.instances[static_cast<std::size_t>(45 * 160 + 80)], 1);
}

TEST(GroundTruthTest, CutFacesAreAWoundAndTheSheetsOwnBorderIsNone) {
  Snapshot snapshot;
  snapshot.surfaces = {cut_square(0.004)};
  ViewDefinition view;
  view.camera.position = Double3{0.03, -0.05, 0.08};
  view.camera.target = Double3{0, 0, 0};
  const GroundTruth truth = ground_truth(SeenFrame(snapshot, {view.camera}, kSize));
  int faces = 0, border = 0;
  for (std::size_t pixel = 0; pixel < truth.wound.size(); ++pixel) {
    const bool is_rim = truth.parts[pixel] == 1 + static_cast<int>(PartKind::kRim);
    faces += truth.wound[pixel] == WoundPart::kCutFace;
    border += is_rim && truth.wound[pixel] == WoundPart::kNothing;
    EXPECT_TRUE(is_rim || truth.wound[pixel] != WoundPart::kCutFace);
  }
  EXPECT_GT(faces, 30);
  EXPECT_GT(border, 30);
}

/// From within a whole wall a picture shows its lining, and nothing of a tool that presses it from outside.
TEST(GroundTruthTest, FromWithinABodyItsLiningIsSeenWhichIsNoWound) {
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("ball", {0, 0, 0}, 0.03, 4)};
  auto topology = std::make_shared<SnapshotTopology>(*snapshot.surfaces[0].topology);
  topology->thickness.assign(topology->triangles.size(), 0.002F);
  snapshot.surfaces[0].topology = topology;
  snapshot.tools = {{.name = "probe",
                     .kind = SnapshotToolKind::kSphere,
                     .radius = 0.004,
                     .tip = {0, 0.0295, 0},
                     .direction = {0, -1, 0}}};
  ViewDefinition view;
  view.camera = {
      .position = Double3{0, 0, 0}, .target = Double3{0, 1, 0}, .up = Double3{0, 0, 1}, .field_of_view = 0.8};
  const GroundTruth truth = ground_truth(SeenFrame(snapshot, {view.camera}, kSize));
  for (std::size_t pixel = 0; pixel < truth.parts.size(); ++pixel) {
    ASSERT_EQ(truth.parts[pixel], 1 + static_cast<int>(PartKind::kLining));
    ASSERT_EQ(truth.wound[pixel], WoundPart::kNothing);
  }
  const std::size_t middle = static_cast<std::size_t>(kSize.width * (kSize.height / 2) + kSize.width / 2);
  // Triangles lie within the ball by up to a hundredth of its radius.
  EXPECT_NEAR(truth.depth[middle], 0.028, 0.0003);
}

/// A ball with a slit over its top along x, whose lips stand apart by 8 mm.
Snapshot opened_ball() {
  SnapshotSurface ball = test::sphere("ball", {0, 0, 0}, 0.03, 4);
  auto topology = std::make_shared<SnapshotTopology>(*ball.topology);
  std::vector<std::uint32_t> twins(ball.positions.size());
  for (std::uint32_t v = 0; v < twins.size(); ++v) {
    const auto [x, y, z] = topology->rest_positions[v];
    twins[v] = v;
    if (z < 0 || std::abs(y) > 1e-6F || std::abs(x) > 0.02F) continue;
    twins[v] = static_cast<std::uint32_t>(ball.positions.size());
    topology->rest_positions.push_back({x, y, z});
    ball.positions[v][1] -= 0.004F;
    ball.positions.push_back({x, y + 0.004F, z});
  }
  for (Triangle& triangle : topology->triangles) {
    const bool is_beyond = std::ranges::any_of(
        triangle, [&](std::uint32_t v) { return v < twins.size() && topology->rest_positions[v][1] > 1e-6F; });
    for (std::uint32_t& v : triangle) v = is_beyond ? twins[v] : v;
  }
  topology->thickness.assign(topology->triangles.size(), 0.001F);
  ball.topology = topology;
  Snapshot snapshot;
  snapshot.surfaces = {ball};
  return snapshot;
}

TEST(GroundTruthTest, TheInnerSideIsAWoundFromOutsideAloneWhereCutsHaveOpenedAClosedWall) {
  ViewDefinition above, within;
  above.camera = {.position = Double3{0, -0.05, 0.1}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}};
  within.camera = {.position = Double3{0, 0, -0.01}, .target = Double3{0, 0.03, 0}, .up = Double3{0, 0, 1}};
  for (const auto& [view, expected] : {std::pair{above, WoundPart::kInside}, std::pair{within, WoundPart::kNothing}}) {
    const GroundTruth truth = ground_truth(SeenFrame(opened_ball(), {view.camera}, kSize));
    int lining = 0;
    for (std::size_t pixel = 0; pixel < truth.parts.size(); ++pixel) {
      if (truth.parts[pixel] != 1 + static_cast<int>(PartKind::kLining)) continue;
      ++lining;
      EXPECT_EQ(truth.wound[pixel], expected) << pixel;
    }
    EXPECT_GT(lining, 100);
  }
}

TEST(GroundTruthTest, ACapIsAWoundWhereAnOpeningShowsIt) {
  Snapshot snapshot = opened_ball();
  auto topology = std::make_shared<SnapshotTopology>(*snapshot.surfaces[0].topology);
  std::vector<Triangle> wall;
  for (const Triangle& triangle : topology->triangles) {
    const bool is_low =
        std::ranges::all_of(triangle, [&](std::uint32_t v) { return topology->rest_positions[v][2] < -0.02F; });
    (is_low ? topology->cap_triangles : wall).push_back(triangle);
  }
  topology->triangles = wall;
  topology->thickness.resize(wall.size());
  snapshot.surfaces[0].topology = topology;
  for (const double side : {1.0, -1.0}) {
    ViewDefinition view;
    view.camera = {.position = Double3{0, 0, 0.1 * side}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}};
    const GroundTruth truth = ground_truth(SeenFrame(snapshot, {view.camera}, kSize));
    int caps = 0;
    for (std::size_t pixel = 0; pixel < truth.parts.size(); ++pixel) {
      if (truth.parts[pixel] != 1 + static_cast<int>(PartKind::kCap)) continue;
      ++caps;
      EXPECT_EQ(truth.wound[pixel], side > 0 ? WoundPart::kInside : WoundPart::kNothing) << pixel;
    }
    EXPECT_GT(caps, 50);
  }
}

TEST(GroundTruthTest, TheUnderSideOfASheetIsNoWound) {
  SnapshotSurface whole =
      test::quad("square", {{{-0.02F, -0.02F, 0}, {0.02F, -0.02F, 0}, {0.02F, 0.02F, 0}, {-0.02F, 0.02F, 0}}});
  auto topology = std::make_shared<SnapshotTopology>(*whole.topology);
  topology->thickness.assign(2, 0.001F);
  whole.topology = topology;
  ViewDefinition view;
  view.camera = {.position = Double3{0, 0.001, -0.08}, .target = Double3{0, 0, 0}};
  for (const SnapshotSurface& sheet : {whole, test::slit_sheet(20, 0.001, 0)}) {
    Snapshot snapshot;
    snapshot.surfaces = {sheet};
    const GroundTruth truth = ground_truth(SeenFrame(snapshot, {view.camera}, kSize));
    int lining = 0;
    for (std::size_t pixel = 0; pixel < truth.parts.size(); ++pixel) {
      if (truth.parts[pixel] != 1 + static_cast<int>(PartKind::kLining)) continue;
      ++lining;
      EXPECT_NE(truth.wound[pixel], WoundPart::kInside) << pixel;
    }
    EXPECT_GT(lining, 300);
  }
}

/// A slit of 18 mm whose lips stand apart by up to 6 mm: a lens of circular arcs, nearly.
TEST(GroundTruthTest, WhatIsSeenThroughAnOpeningIsAWoundToo) {
  SnapshotSurface sheet = test::slit_sheet(20, 0.001, 0);
  const auto is_slit = [](float x) { return std::abs(x) < 0.0085F; };
  for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
    auto& [x, y, z] = sheet.positions[v];
    const float opened = 0.003F * std::max(0.0F, 1 - x * x / 0.000081F);
    // Twins come last; they are of the side of +y.
    if (y == 0 && is_slit(x))
      y = v < 21 * 21 ? -opened : opened;
    else if (y != 0)
      y += (y > 0 ? 1.0F : -1.0F) * opened * std::max(0.0F, 1 - std::abs(y) / 0.01F);
  }
  Snapshot snapshot;
  snapshot.surfaces = {sheet};
  ViewDefinition view;
  view.camera.position = Double3{0, 0, 0.05};
  view.camera.target = Double3{0, 0, 0};
  const SeenFrame frame(snapshot, {view.camera}, kSize);
  const GroundTruth truth = ground_truth(frame);
  int through = 0, outside = 0;
  const Camera& camera = frame.camera();
  for (std::size_t pixel = 0; pixel < truth.wound.size(); ++pixel) {
    const bool is_through = truth.wound[pixel] == WoundPart::kThrough;
    through += is_through;
    outside += !is_through && truth.instances[pixel] == 0;
    EXPECT_TRUE(!is_through || (truth.instances[pixel] == 0 && truth.depth[pixel] == 0));
  }
  // Two thirds of length times width, of pixels that are so large there; the faces of the cut hide a part of it.
  const double pixel_size = 2 * camera.tangent_y * 0.05 / kSize.height;
  const double whole = 2.0 / 3 * 0.018 * 0.006 / (pixel_size * pixel_size);
  EXPECT_GT(through, 0.4 * whole);
  EXPECT_LT(through, 1.02 * whole);
  EXPECT_GT(outside, through) << "beside the sheet is no wound";
}

TEST(GroundTruthTest, StressIsThatOfTheTriangleAndPressureRunsEvenly) {
  Snapshot snapshot;
  snapshot.surfaces = {test::quad("wall", {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}})};
  snapshot.surfaces[0].fields = {
      {.name = "contact_pressure", .unit = "Pa", .location = FieldLocation::kVertex, .values = {0, 200, 200, 0}},
      {.name = "largest_principal_stress", .unit = "Pa", .location = FieldLocation::kTriangle, .values = {300, 500}},
      {.name = "smallest_principal_stress", .unit = "Pa", .location = FieldLocation::kTriangle, .values = {300, 0}}};
  ViewDefinition view;
  view.camera.position = Double3{0, 0, 3};
  view.camera.target = Double3{0, 0, 0};
  view.camera.up = Double3{0, 1, 0};
  const SeenFrame frame(snapshot, {view.camera}, kSize);
  const GroundTruth truth = ground_truth(frame);
  int seen = 0;
  for (std::size_t pixel = 0; pixel < truth.depth.size(); ++pixel) {
    if (truth.instances[pixel] == 0) continue;
    ++seen;
    const auto& ray = *frame.moment().projection.rays()[pixel];
    const double x = 3 * ray[0], y = -3 * ray[1];
    EXPECT_NEAR(truth.contact_pressure[pixel], 100 * (x + 1), 1e-3);
    if (std::abs(x - y) < 1e-3) continue;
    EXPECT_FLOAT_EQ(truth.von_mises[pixel], x > y ? 300 : 500);
  }
  EXPECT_GT(seen, 1000);
  snapshot.surfaces[0].fields.clear();
  EXPECT_TRUE(ground_truth(SeenFrame(snapshot, {view.camera}, kSize)).von_mises.empty());
}

TEST(GroundTruthTest, AWallIsPressedWhicheverOfItsSidesIsSeen) {
  Snapshot snapshot = opened_ball();
  SnapshotSurface& surface = snapshot.surfaces[0];
  surface.fields = {{.name = std::string(kContactPressureField),
                     .unit = "Pa",
                     .location = FieldLocation::kVertex,
                     .values = std::vector<float>(surface.positions.size(), 100)}};
  ViewDefinition view;
  view.camera = {.position = Double3{0, -0.05, 0.1}, .target = Double3{0, 0, 0}, .up = Double3{0, 1, 0}};
  const GroundTruth truth = ground_truth(SeenFrame(snapshot, {view.camera}, kSize));
  for (const PartKind kind : {PartKind::kOutside, PartKind::kRim, PartKind::kLining}) {
    int seen = 0;
    for (std::size_t pixel = 0; pixel < truth.parts.size(); ++pixel) {
      if (truth.parts[pixel] != 1 + static_cast<int>(kind)) continue;
      ++seen;
      EXPECT_FLOAT_EQ(truth.contact_pressure[pixel], 100) << pixel;
    }
    EXPECT_GT(seen, 20) << static_cast<int>(kind);
  }
}

TEST(GroundTruthTest, ToolsHaveTheVeryTrianglesOfThePictures) {
  for (std::size_t kind = 0; kind < kSnapshotToolKindNames.size(); ++kind) {
    Snapshot snapshot = scene();
    snapshot.tools = {{.name = "tool",
                       .kind = static_cast<SnapshotToolKind>(kind),
                       .radius = 0.002,
                       .length = 0.02,
                       .width = 0.006,
                       .thickness = 0.0006,
                       .opening = 0.004}};
    const SceneExtent extent = scene_extent(snapshot);
    const ToolShape drawn = tool_shape(snapshot.tools[0], extent.size, ToolDetail::kSeen);
    const SceneGeometry geometry = scene_geometry(snapshot, extent, DrawnEdges::kCurvedLips, {0, 0, 1});
    const ScenePart& part = geometry.parts.back();
    ASSERT_EQ(part.kind, PartKind::kTool);
    ASSERT_EQ(3 * part.triangle_count, drawn.indices.size()) << kSnapshotToolKindNames.at(kind);
    for (std::size_t i = 0; i < drawn.indices.size(); ++i) {
      const std::uint32_t corner = geometry.triangles[part.first_triangle + i / 3].corners[i % 3];
      ASSERT_EQ(length(geometry.points[corner] - vector3(drawn.vertices[drawn.indices[i]].position)), 0);
    }
  }
}

TEST(GroundTruthTest, TellsStretchesAndThicknessOverTheShapeWithoutStress) {
  SnapshotSurface surface = test::quad("wall", {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}});
  auto topology = std::make_shared<SnapshotTopology>(*surface.topology);
  topology->thickness = {0.004F, 0.004F};
  // The first triangle has edges (2, 0) and (2, 1), the second (2, 1) and (0, 1): shrunk to a half along x.
  topology->rest_metric = {{1, 2, 1}, {2, 1, 1}};
  surface.topology = topology;
  for (Float3& position : surface.positions) position[1] *= 1.5F;
  for (const auto& [larger, smaller] : principal_stretches(surface)) {
    EXPECT_NEAR(larger, 2, 1e-6);
    EXPECT_NEAR(smaller, 1.5, 1e-6);
  }
  for (const double thickness : current_thickness(surface)) EXPECT_NEAR(thickness, 0.004 / 3, 1e-8);
}

}  // namespace
}  // namespace thinwall
