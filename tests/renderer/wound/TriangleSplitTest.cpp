#include "renderer/wound/TriangleSplit.hpp"

#include <gtest/gtest.h>

#include <map>

namespace thinwall {
namespace {

using Weights = std::array<double, 3>;

/// Area in the plane of the weights, over the whole triangle's.
double area_of(const SplitTriangle& piece) {
  const auto& [a, b, c] = piece.weights;
  return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

/// Points of an edge are numbered from 10 (edge + 1) on.
std::array<std::vector<std::uint32_t>, 3> points(const std::array<std::size_t, 3>& counts) {
  std::array<std::vector<std::uint32_t>, 3> result;
  for (std::uint32_t k = 0; k < 3; ++k) {
    for (std::uint32_t i = 0; i < counts[k]; ++i) result[k].push_back(10 * (k + 1) + i);
  }
  return result;
}

/// Where a vertex lies.
Weights place_of(std::uint32_t vertex, const std::array<std::size_t, 3>& counts) {
  Weights weights{};
  if (vertex < 3) {
    weights[vertex] = 1;
    return weights;
  }
  const std::size_t edge = vertex / 10 - 1;
  const double along = (vertex % 10 + 1.0) / (static_cast<double>(counts[edge]) + 1);
  weights[edge] = 1 - along;
  weights[(edge + 1) % 3] = along;
  return weights;
}

TEST(TriangleSplit, CoversTheTriangleOnceWhateverIsOnItsEdges) {
  for (const std::size_t a : {0U, 1U, 3U}) {
    for (const std::size_t b : {0U, 1U, 3U}) {
      for (const std::size_t c : {0U, 1U, 3U}) {
        const std::array counts{a, b, c};
        std::vector<SplitTriangle> pieces;
        split_triangle({0, 1, 2}, points(counts), pieces);
        double sum = 0;
        std::map<std::uint32_t, int> uses;
        for (const SplitTriangle& piece : pieces) {
          EXPECT_GT(area_of(piece), 0) << a << b << c;
          sum += area_of(piece);
          for (std::size_t k = 0; k < 3; ++k) {
            ++uses[piece.vertices[k]];
            EXPECT_EQ(piece.weights[k], place_of(piece.vertices[k], counts)) << a << b << c;
          }
        }
        EXPECT_EQ(sum, 1) << a << b << c;
        EXPECT_EQ(uses.size(), 3 + a + b + c) << "each point is a corner: neighbours fit";
        EXPECT_EQ(pieces.size(), 1 + a + b + c);
      }
    }
  }
}

}  // namespace
}  // namespace thinwall
