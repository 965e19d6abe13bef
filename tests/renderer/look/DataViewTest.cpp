#include "renderer/look/DataView.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/look/ColorMap.hpp"
#include "renderer/look/VertexAreas.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

TEST(DataViewTest, ColorsAreThoseOfViridis) {
  // Of the published table, rows 0, 64, 128, 191 and 255.
  const std::array<std::pair<double, Double3>, 5> table = {{{0, {0.267, 0.005, 0.329}},
                                                            {64 / 255.0, {0.229, 0.322, 0.546}},
                                                            {128 / 255.0, {0.128, 0.567, 0.551}},
                                                            {191 / 255.0, {0.363, 0.785, 0.387}},
                                                            {1, {0.993, 0.906, 0.144}}}};
  for (const auto& [value, expected] : table) {
    const Double3 color = color_map(value);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(color[k], expected[k], 0.015) << value << " " << k;
  }
  EXPECT_EQ(color_map(-3), color_map(0));
  EXPECT_EQ(color_map(7), color_map(1));
}

TEST(DataViewTest, TheRootScaleGivesTheLowestQuarterHalfOfTheColors) {
  EXPECT_EQ(color_place(0.25, DataScale::kLinear), 0.25);
  EXPECT_EQ(color_place(0.25, DataScale::kRoot), 0.5);
  for (const DataScale scale : {DataScale::kLinear, DataScale::kRoot}) {
    EXPECT_EQ(color_place(0, scale), 0);
    EXPECT_EQ(color_place(-2, scale), 0);
    EXPECT_EQ(color_place(1, scale), 1);
    EXPECT_EQ(color_place(9, scale), 1);
  }
}

TEST(DataViewTest, ColorsBecomeLighterAllTheWay) {
  double before = -1;
  for (int step = 0; step <= 100; ++step) {
    const Double3 color = color_map(step / 100.0);
    const double lightness =
        0.2126 * std::pow(color[0], 2.2) + 0.7152 * std::pow(color[1], 2.2) + 0.0722 * std::pow(color[2], 2.2);
    EXPECT_GT(lightness, before) << step;
    before = lightness;
  }
}

SnapshotSurface stretched_square() {
  SnapshotSurface surface = test::quad("wall", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  auto topology = std::make_shared<SnapshotTopology>(*surface.topology);
  topology->thickness = {0.002F, 0.002F};
  topology->rest_metric = {{1, 2, 1}, {2, 1, 1}};
  surface.topology = topology;
  for (Float3& position : surface.positions) position[0] *= 1.25F;
  surface.fields = {
      {.name = "contact_pressure", .unit = "Pa", .location = FieldLocation::kVertex, .values = {1, 2, 3, 4}},
      {.name = "largest_principal_stress", .unit = "Pa", .location = FieldLocation::kTriangle, .values = {50, 50}},
      {.name = "smallest_principal_stress", .unit = "Pa", .location = FieldLocation::kTriangle, .values = {30, 10}}};
  return surface;
}

TEST(DataViewTest, VerticesStandForAThirdOfTheTrianglesAround) {
  const std::vector<double> areas = vertex_areas(*stretched_square().topology);
  ASSERT_EQ(areas.size(), 4u);
  // Two triangles of half a square each; two corners belong to both.
  double whole = 0;
  for (const double area : areas) {
    EXPECT_TRUE(std::abs(area - 1.0 / 6) < 1e-12 || std::abs(area - 1.0 / 3) < 1e-12) << area;
    whole += area;
  }
  EXPECT_NEAR(whole, 1, 1e-12);
}

TEST(DataViewTest, QuantitiesAreThoseOfTheWall) {
  const SnapshotSurface surface = stretched_square();
  for (const float strain : data_values(surface, DataQuantity::kStrain)) EXPECT_NEAR(strain, 0.25, 1e-6);
  for (const float thickness : data_values(surface, DataQuantity::kThickness)) EXPECT_NEAR(thickness, 0.0016, 1e-9);
  EXPECT_EQ(data_values(surface, DataQuantity::kContactPressure), (std::vector<float>{1, 2, 3, 4}));
  EXPECT_EQ(data_values(surface, DataQuantity::kLargestStress), (std::vector<float>(4, 50)));
  // The first triangle has vertices 0, 1 and 2, the second 0, 2 and 3, both of one size.
  EXPECT_EQ(data_values(surface, DataQuantity::kSmallestStress), (std::vector<float>{20, 30, 20, 10}));
  EXPECT_NEAR(data_values(surface, DataQuantity::kVonMisesStress)[1], std::sqrt(1900), 1e-4);
  EXPECT_NEAR(data_values(surface, DataQuantity::kDisplacement)[1], 0.25, 1e-7);
}

TEST(DataViewTest, WhatASnapshotDoesNotHoldIsRefused) {
  SnapshotSurface surface = test::quad("wall", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  for (const DataQuantityRow& row : data_quantities()) {
    if (row.quantity == DataQuantity::kDisplacement) continue;
    try {
      data_values(surface, row.quantity);
      FAIL() << row.word;
    } catch (const PictureFailure& failure) {
      EXPECT_NE(std::string(failure.what()).find(row.word), std::string::npos) << failure.what();
    }
  }
}

}  // namespace
}  // namespace thinwall
