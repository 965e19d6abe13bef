#include "renderer/metric/LayerDifference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace thinwall {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

FloatImage layer(int channels, std::vector<float> values, int width) {
  const int height = static_cast<int>(values.size()) / channels / width;
  return {.size = {width, height}, .channels = channels, .values = std::move(values)};
}

TEST(LayerDifference, DepthIsComparedInMetres) {
  const FloatImage first = layer(1, {0.1F, 0.1F, 0.1F, kNothing}, 2);
  const FloatImage second = layer(1, {0.1F, 0.1004F, 0.1F, kNothing}, 2);
  const LayerDifference result = compare_layers(first, second, LayerKind::kDepth, {.difference = 1e-4});
  EXPECT_EQ(result.compared, 3);
  EXPECT_EQ(result.failing, 1);
  EXPECT_NEAR(result.largest, 4e-4, 1e-8);
  EXPECT_EQ(result.worst, (std::array{1, 0}));
  EXPECT_EQ(compare_layers(first, second, LayerKind::kDepth, {.difference = 5e-4}).failing, 0);
}

TEST(LayerDifference, ASilhouetteMayMoveWithinTheEdgeBandOnly) {
  const FloatImage first = layer(1, {0.1F, 0.1F, kNothing, kNothing, kNothing}, 5);
  const FloatImage one = layer(1, {0.1F, 0.1F, 0.1F, kNothing, kNothing}, 5);
  const FloatImage two = layer(1, {0.1F, 0.1F, 0.1F, 0.1F, kNothing}, 5);
  const LayerTolerance tolerance{.difference = 1e-5, .edge_band = 1};
  EXPECT_EQ(compare_layers(first, one, LayerKind::kDepth, tolerance).failing, 0);
  EXPECT_EQ(compare_layers(first, two, LayerKind::kDepth, tolerance).failing, 2);
  EXPECT_EQ(compare_layers(first, one, LayerKind::kDepth, {.difference = 1e-5, .edge_band = 0}).only_in_one, 1);
}

TEST(LayerDifference, ASmoothDepthThatMovesIsNotExcusedAsAnEdge) {
  const FloatImage first = layer(1, {0.1F, 0.1002F, 0.1004F, 0.1006F}, 4);
  const FloatImage second = layer(1, {0.1002F, 0.1004F, 0.1006F, 0.1008F}, 4);
  EXPECT_EQ(compare_layers(first, second, LayerKind::kDepth, {.difference = 1e-5}).failing, 4);
}

TEST(LayerDifference, NormalsAreComparedByAngleWhateverTheirLength) {
  const auto angle = static_cast<float>(2 * M_PI / 180);
  const FloatImage first = layer(3, {0, 0, 1, 0, 0, 1, 0, 0, 0}, 3);
  const FloatImage second = layer(3, {0, 0, 7, 0, std::sin(angle), std::cos(angle), 0, 0, 0}, 3);
  const LayerDifference result = compare_layers(first, second, LayerKind::kNormal, {.difference = 1});
  EXPECT_EQ(result.compared, 2);
  EXPECT_EQ(result.failing, 1);
  EXPECT_NEAR(result.largest, 2, 1e-5);
  EXPECT_NEAR(result.mean, 1, 1e-5);
}

TEST(LayerDifference, OppositeNormalsAreHalfATurnApart) {
  const LayerDifference result =
      compare_layers(layer(3, {0, 0, 1}, 1), layer(3, {0, 0, -1}, 1), LayerKind::kNormal, {});
  EXPECT_NEAR(result.largest, 180, 1e-9);
}

TEST(LayerDifference, IdsAreComparedByTheirOverlap) {
  const FloatImage first = layer(1, {1, 1, 1, 2, 2, 0}, 6);
  const FloatImage second = layer(1, {1, 1, 2, 2, 2, 0}, 6);
  const LayerDifference result = compare_layers(first, second, LayerKind::kIds);
  EXPECT_EQ(result.failing, 1);
  EXPECT_NEAR(result.smallest_overlap, 2.0 / 3, 1e-12);
  EXPECT_EQ(result.worst, (std::array{2, 0}));
}

TEST(LayerDifference, AnIdThatIsGoneHasNoOverlap) {
  const LayerDifference result = compare_layers(layer(1, {1, 5}, 2), layer(1, {1, 1}, 2), LayerKind::kIds);
  EXPECT_EQ(result.smallest_overlap, 0);
  EXPECT_EQ(result.smallest_overlap_id, 5);
}

TEST(LayerDifference, FlowIsComparedByItsEndPoints) {
  const LayerDifference result =
      compare_layers(layer(2, {0, 0, 1, 1}, 2), layer(2, {3, 4, 1, 1}, 2), LayerKind::kFlow, {.difference = 4.9});
  EXPECT_EQ(result.failing, 1);
  EXPECT_DOUBLE_EQ(result.largest, 5);
  EXPECT_DOUBLE_EQ(result.mean, 2.5);
}

}  // namespace
}  // namespace thinwall
