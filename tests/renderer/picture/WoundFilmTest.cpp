#include "renderer/picture/WoundFilm.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/picture/DrawnPieces.hpp"
#include "tests/renderer/picture/CutSheets.hpp"

namespace thinwall {
namespace {

struct Wound {
  explicit Wound(double steepness) : sheet(test::slit_sheet(20, 0.001, steepness)) {
    borders = border_edges(*sheet.topology);
    pieces = drawn_pieces(sheet, drawn_topology(sheet.topology, DrawnEdges::kStraight), sheet);
    layout = lay_out_wounds(*sheet.topology, borders, cut_lips(*sheet.topology, borders), {0, 0, -1});
  }
  Film blood(double time, double bleeding = 1) const {
    return blood_film(sheet, borders, pieces, layout, bleeding, time);
  }

  SnapshotSurface sheet;
  std::vector<BorderEdge> borders;
  std::vector<TissuePiece> pieces;
  WoundLayout layout;
};

/// Metres that blood has come down.
double lowest(const Film& film) {
  double lowest = 0;
  for (const std::uint32_t corner : film.corners) {
    if (film.vertices[corner].inward > 0) lowest = std::min(lowest, double{film.vertices[corner].position[2]});
  }
  return -lowest;
}

TEST(WoundFilm, IsNoneWhereNothingBleeds) {
  // Beside the fresh cut no blood has welled up yet.
  for (const FilmVertex& vertex : Wound(0).blood(0).vertices) EXPECT_LE(vertex.inward, 0);
  for (const FilmVertex& vertex : Wound(0).blood(10, 0).vertices) EXPECT_LE(vertex.inward, 0);
}

TEST(WoundFilm, WellsUpAlongTheLipsButNotAtTheEndsOfTheCut) {
  const Wound wound(0);
  const Film film = wound.blood(5);
  const std::uint32_t middle = 10 * 21;
  EXPECT_GT(film.vertices[middle + 10].inward, 0.0005F);
  EXPECT_LE(film.vertices[middle + 1].inward, 0);
  EXPECT_LE(film.vertices[middle + 19].inward, 0);
  EXPECT_LT(film.vertices[5].inward, 0) << "far away";
}

TEST(WoundFilm, RunsDownASlopeMoreAndMore) {
  const Wound wound(0.8);
  double last = lowest(wound.blood(0.2));
  for (const double time : {0.3, 0.45, 0.7}) {
    const double now = lowest(wound.blood(time));
    EXPECT_GT(now, last) << time;
    last = now;
  }
  EXPECT_LT(lowest(wound.blood(4)), 0.010) << "not beyond the sheet";
}

TEST(WoundFilm, BeginsAsThinLinesThatEndInNoKnobs) {
  constexpr double kSteepness = 0.8;
  const Wound wound(kSteepness);
  for (const double time : {0.3, 0.5, 0.7}) {
    const Film film = wound.blood(time);
    double half_width = 0;
    for (const FilmVertex& vertex : film.vertices) {
      const bool is_run = vertex.lift > 0.0001F;
      if (is_run) half_width = std::max(half_width, double{vertex.inward});
    }
    EXPECT_GT(half_width, 0) << time;
    EXPECT_LT(half_width, 0.1 * lowest(film) / std::sin(kSteepness)) << time;
  }
}

TEST(WoundFilm, IsAFunctionOfTheMomentAlone) {
  const Wound wound(0.8);
  const Film alone = wound.blood(2);
  wound.blood(1);
  const Film again = wound.blood(2);
  ASSERT_EQ(alone.vertices.size(), again.vertices.size());
  for (std::size_t v = 0; v < alone.vertices.size(); ++v) {
    EXPECT_EQ(alone.vertices[v].position, again.vertices[v].position);
    EXPECT_EQ(alone.vertices[v].inward, again.vertices[v].inward);
  }
}

TEST(WoundFilm, DriesWithTime) {
  const Wound wound(0);
  const std::uint32_t lip = 10 * 21 + 10;
  EXPECT_LT(wound.blood(1).vertices[lip].dry, 0.02F);
  EXPECT_GT(wound.blood(120).vertices[lip].dry, 0.85F);
}

TEST(WoundFilm, TheWallIsBareAlongTheLipsFromTheStart) {
  const Wound wound(0);
  const Film film = bare_edge_film(wound.sheet, wound.pieces, wound.layout, 1);
  const std::uint32_t middle = 10 * 21;
  EXPECT_GT(film.vertices[middle + 10].inward, 0.0003F);
  EXPECT_LE(film.vertices[middle + 1].inward, 0) << "an end of the cut";
  EXPECT_LT(film.vertices[5].inward, 0) << "far away";
}

TEST(WoundFilm, WhatRunsOutWetsTheLips) {
  const Wound wound(0);
  const std::uint32_t lip = 10 * 21 + 10;
  const auto wet = [&](double leaked) {
    return runoff_film(wound.sheet, wound.pieces, wound.layout, leaked, 1).vertices[lip].inward;
  };
  EXPECT_GT(wet(1e-6), 0.0005F);
  EXPECT_LT(wet(1e-9), 0.1F * wet(1e-6));
}

TEST(WoundFilm, BloodClingsToLipsInBeadsWhichNothingThatRunsDoes) {
  const Wound wound(0.8);
  const auto most_beads = [](const Film& film, bool of_runs) {
    float most = 0;
    for (const FilmVertex& vertex : film.vertices) {
      if ((vertex.lift > 0.0001F) == of_runs) most = std::max(most, vertex.beads);
    }
    return most;
  };
  EXPECT_EQ(most_beads(wound.blood(1), false), 1);
  EXPECT_EQ(most_beads(wound.blood(1), true), 0);
  EXPECT_EQ(most_beads(runoff_film(wound.sheet, wound.pieces, wound.layout, 1e-6, 1), false), 0);
}

TEST(WoundFilm, RunsAreRoundAtBothEnds) {
  const Wound wound(0.8);
  const Film film = wound.blood(4);
  // Rows of three across a run: at its first and last one the trail has no width.
  std::size_t ends = 0;
  for (std::size_t v = 1; v + 1 < film.vertices.size(); ++v) {
    const bool is_row = film.vertices[v].lift > 1e-4F && film.vertices[v - 1].inward < 0 &&
                        film.vertices[v + 1].inward < 0 && film.vertices[v].inward >= 0;
    if (is_row && film.vertices[v].inward == 0) ++ends;
  }
  EXPECT_EQ(ends, 2 * wound.layout.blood_runs.size());
}

/// The edge of a drop is where `inward` is zero; the shader draws it only where triangles reach beyond.
TEST(WoundFilm, TheDropAtTheEndOfARunIsDrawnWhole) {
  const Film film = Wound(0.8).blood(4);
  std::size_t heads = 0;
  for (std::size_t v = 2; v + 4 < film.vertices.size(); v += 1) {
    const bool is_head = film.vertices[v].lift > 1e-4F && film.vertices[v].inward == 0 &&
                         film.vertices[v - 3].inward > 0 && film.vertices[v - 1].inward < 0;
    if (!is_head) continue;
    ++heads;
    EXPECT_LT(film.vertices[v + 3].inward, 0);
    const Vector3 beyond = vector3(film.vertices[v + 3].position) - vector3(film.vertices[v].position);
    EXPECT_NEAR(length(beyond), 0.0003, 1e-6);
    EXPECT_LT(beyond.z, 0);
  }
  EXPECT_EQ(heads, Wound(0.8).layout.blood_runs.size());
}

TEST(WoundFilm, RunOffNeedsALeak) {
  const Wound wound(0.8);
  EXPECT_TRUE(runoff_film(wound.sheet, wound.pieces, wound.layout, 0, 5).corners.empty());
  const Film some = runoff_film(wound.sheet, wound.pieces, wound.layout, 4e-9, 5);
  const Film much = runoff_film(wound.sheet, wound.pieces, wound.layout, 4e-7, 5);
  EXPECT_GT(lowest(some), 0.001);
  EXPECT_GT(lowest(much), 1.5 * lowest(some));
}

}  // namespace
}  // namespace thinwall
