#include "renderer/camera/Magnification.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

Snapshot ball(double radius) {
  Snapshot snapshot;
  snapshot.surfaces = {test::sphere("organ", {0, 0, 0}, static_cast<float>(radius), 2)};
  snapshot.surfaces[0].fields = {{.name = "gap", .unit = "m", .values = {0.001F}},
                                 {.name = "mean_stress", .unit = "Pa", .values = {7}}};
  snapshot.tools = {{.name = "needle", .radius = 0.1e-3, .tip = {0, 0, 1e-3}, .depth = 0.2e-3, .force = {0, 0, 1e-4}}};
  snapshot.scalars = {{"organ.leaked", "m^3", 1e-10}, {"organ.pressure", "Pa", 500}};
  return snapshot;
}

TEST(Magnification, IsAPowerOfTwoThatBringsTinyScenesToACentimetre) {
  EXPECT_EQ(magnification_of({}), 1);
  EXPECT_EQ(magnification_of(ball(0.01)), 1);
  for (const double radius : {3e-3, 0.5e-3, 20e-6}) {
    const double factor = magnification_of(ball(radius));
    EXPECT_EQ(std::exp2(std::round(std::log2(factor))), factor);
    EXPECT_GE(factor * radius * std::sqrt(12.0), 0.0119) << radius;
    EXPECT_LT(factor * radius * std::sqrt(12.0), 0.0241) << radius;
  }
}

TEST(Magnification, MakesAllLengthsLargerAndNothingElse) {
  const Snapshot small = ball(0.5e-3);
  Magnifier magnifier;
  const Snapshot large = magnifier.magnified(small, 8);
  EXPECT_EQ(large.surfaces[0].positions[3][1], 8 * small.surfaces[0].positions[3][1]);
  EXPECT_EQ(large.surfaces[0].topology->rest_positions[3][1], 8 * small.surfaces[0].topology->rest_positions[3][1]);
  EXPECT_EQ(large.surfaces[0].fields[0].values[0], 0.008F);
  EXPECT_EQ(large.surfaces[0].fields[1].values[0], 7);
  EXPECT_EQ(large.tools[0].tip[2], 8e-3);
  EXPECT_EQ(large.tools[0].radius, 0.8e-3);
  EXPECT_EQ(large.tools[0].force, small.tools[0].force);
  EXPECT_DOUBLE_EQ(large.scalars[0].value, 512e-10);
  EXPECT_EQ(large.scalars[1].value, 500);
  EXPECT_EQ(magnifier.magnified(small, 8).surfaces[0].topology, large.surfaces[0].topology)
      << "what follows from a topology is kept as long as it is the same";
}

TEST(Magnification, KeepsWhatACameraSees) {
  const CameraDefinition camera{.position = Double3{1, 2, 3},
                                .field_of_view = 0.4,
                                .keyframes = {{.time = 1, .position = Double3{0, 1, 0}}},
                                .aperture = 0.001,
                                .focus = 0.05};
  const CameraDefinition large = magnified(camera, 4);
  EXPECT_EQ(*large.position, (Double3{4, 8, 12}));
  EXPECT_FALSE(large.target);
  EXPECT_EQ(large.field_of_view, 0.4);
  EXPECT_EQ(*large.keyframes[0].position, (Double3{0, 4, 0}));
  EXPECT_EQ(large.aperture, 0.004);
  EXPECT_EQ(*large.focus, 0.2);
}

TEST(Magnification, KeepsTheColoursOfData) {
  ViewDefinition view;
  view.look.data = DataView{.quantity = DataQuantity::kThickness, .from = 0.0, .to = 1e-4};
  EXPECT_EQ(magnified(view, 8).look.data->to, 8e-4);
  view.look.data->quantity = DataQuantity::kStrain;
  EXPECT_EQ(magnified(view, 8).look.data->to, 1e-4);
}

}  // namespace
}  // namespace thinwall
