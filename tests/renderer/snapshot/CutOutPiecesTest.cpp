#include "renderer/snapshot/CutOutPieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

/// A cube of six sides, of which those in `apart` have vertices of their own.
SnapshotTopology cube(std::uint32_t apart) {
  SnapshotTopology topology;
  const auto corner = [&](std::uint32_t side_set, std::uint32_t place) {
    const Float3 at = {static_cast<float>(place & 1), static_cast<float>(place >> 1 & 1),
                       static_cast<float>(place >> 2)};
    topology.rest_positions.resize(16);
    topology.rest_positions[8 * side_set + place] = at;
    return 8 * side_set + place;
  };
  const std::array<std::array<std::uint32_t, 4>, 6> sides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (std::uint32_t s = 0; s < 6; ++s) {
    const std::uint32_t set = s < apart ? 1 : 0;
    std::array<std::uint32_t, 4> v;
    for (std::size_t k = 0; k < 4; ++k) v[k] = corner(set, sides[s][k]);
    topology.triangles.push_back({v[0], v[1], v[2]});
    topology.triangles.push_back({v[0], v[2], v[3]});
  }
  return topology;
}

/// How many of the vertices belong to pieces that were cut out.
std::ptrdiff_t cut_out(std::span<const std::uint32_t> pieces) {
  return std::ranges::count_if(pieces, [](std::uint32_t piece) { return piece != kHeldPiece; });
}

TEST(CutOutPieces, AreThoseThatNoBorderOfTheSheetHolds) {
  const std::vector<std::uint32_t> pieces = cut_out_pieces(*test::patched_sheet(8, 0.001, 4).topology);
  ASSERT_EQ(pieces.size(), 81U + 25U);
  EXPECT_EQ(cut_out(pieces), 25);
  EXPECT_EQ(std::ranges::count(std::span(pieces).last(25), pieces.back()), 25);
}

TEST(CutOutPieces, AreNoneWhileACutIsNotClosed) {
  EXPECT_EQ(cut_out(cut_out_pieces(*test::slit_sheet(8, 0.001, 0).topology)), 0);
  // Both halves reach the borders of the strip.
  EXPECT_EQ(cut_out(cut_out_pieces(test::cut_strip())), 0);
}

TEST(CutOutPieces, OfAClosedBodyAreAllButTheLargest) {
  const std::vector<std::uint32_t> pieces = cut_out_pieces(cube(1));
  EXPECT_EQ(cut_out(pieces), 4);
  EXPECT_EQ(cut_out(std::span(pieces).first(8)), 0);
  EXPECT_EQ(cut_out(cut_out_pieces(cube(0))), 0);
}

TEST(CutOutPieces, AreNotBodiesThatWereApartFromTheBeginning) {
  SnapshotTopology two = cube(0);
  two.rest_positions.resize(8);
  const std::size_t triangles = two.triangles.size();
  for (std::size_t v = 0; v < 8; ++v) {
    Float3 place = two.rest_positions[v];
    two.rest_positions.push_back({place[0] + 9, 0.5F * place[1], place[2]});
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    const Triangle triangle = two.triangles[t];
    two.triangles.push_back({triangle[0] + 8, triangle[1] + 8, triangle[2] + 8});
  }
  EXPECT_EQ(cut_out(cut_out_pieces(two)), 0);
}

}  // namespace
}  // namespace thinwall
