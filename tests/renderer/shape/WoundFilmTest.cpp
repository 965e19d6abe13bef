#include "renderer/shape/WoundFilm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "renderer/shape/DrawnPieces.hpp"
#include "renderer/shape/WoundCoat.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

struct Wound {
  explicit Wound(double steepness) : sheet(test::slit_sheet(20, 0.001, steepness)) {
    borders = border_edges(*sheet.topology);
    pieces = drawn_pieces(sheet, drawn_topology(sheet.topology, DrawnEdges::kStraight), sheet);
    const std::vector<char> is_lip = cut_lips(*sheet.topology, borders);
    layout = lay_out_wounds(*sheet.topology, borders, is_lip, {0, 0, -1});
    layout.fringe = fringe_mesh(*sheet.topology, borders, is_lip, layout.map);
  }
  Film blood(double time, double bleeding = 1) const {
    return blood_film(sheet, borders, pieces, layout, {.strength = bleeding}, time);
  }
  Film runoff(double leaked, double time = 1) const {
    return runoff_film(sheet, borders, pieces, layout, leaked, time);
  }
  Film bare_edge(double time) const { return bare_edge_film(sheet, borders, pieces, layout, time); }
  /// Vertices of a film of the fringe: first in it, and first of them the wall's.
  std::size_t fringe_size() const { return pieces.front().vertices.size() + layout.fringe.points.size(); }

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

/// Fullness of a coat, see Film.hpp.
double fullness(const FilmVertex& vertex) {
  return vertex.inward / vertex.width;
}

TEST(WoundFilm, WellsUpAlongTheLipsButNotAtTheEndsOfTheCut) {
  const Wound wound(0);
  const Film film = wound.blood(5);
  const std::uint32_t middle = 10 * 21;
  EXPECT_GT(fullness(film.vertices[middle + 10]), 0.5);
  EXPECT_LT(fullness(film.vertices[middle + 1]), -0.5);
  EXPECT_LT(fullness(film.vertices[middle + 19]), -0.5);
  EXPECT_LT(fullness(film.vertices[5]), -2) << "far away";
}

TEST(WoundFilm, LipsThatGapeHoldTheirBlood) {
  Wound wound(0);
  const std::uint32_t middle = 10 * 21 + 10;
  const double closed = fullness(wound.blood(5).vertices[middle]);
  wound.sheet.positions[middle][1] -= 0.003F;
  const double open = fullness(wound.blood(5).vertices[middle]);
  EXPECT_LT(open, closed - 0.5);
  EXPECT_GT(open, -0.5) << "here and there it comes over them";
}

TEST(WoundFilm, CoatsTheFacesOfACutMoreTheDeeper) {
  const Wound wound(0);
  const Film film = wound.blood(2);
  const std::size_t faces_from = wound.fringe_size();
  const auto& rim = *std::ranges::find(wound.pieces, TissueSide::kRim, &TissuePiece::side);
  int faces = 0;
  for (std::size_t v = 0; v < rim.vertices.size(); v += 2) {
    const FilmVertex &outer = film.vertices[faces_from + v], &inner = film.vertices[faces_from + v + 1];
    if (fullness(inner) < 0) continue;
    ++faces;
    EXPECT_EQ(outer.kind, kFilmCoat);
    EXPECT_GT(fullness(inner), fullness(outer) + 0.3) << v;
  }
  EXPECT_GT(faces, 40);
}

/// Fullness along the outer edge of a cut's faces, the least but for where the cut ends. `film`: of that wound.
double fullness_of_edges(const Wound& wound, const Film& film) {
  const auto& rim = *std::ranges::find(wound.pieces, TissueSide::kRim, &TissuePiece::side);
  double least = 10;
  for (std::size_t v = 0; v < rim.vertices.size(); v += 2) {
    const bool is_inner = std::abs(rim.vertices[v].rest[0]) < 0.004F && std::abs(rim.vertices[v].rest[1]) < 0.0001F;
    if (!is_inner) continue;
    const FilmVertex& coat = film.vertices.at(wound.fringe_size() + v);
    EXPECT_EQ(coat.position, rim.vertices[v].position);
    least = std::min(least, fullness(coat));
  }
  return least;
}

TEST(WoundFilm, WhatComesOverALipHasComeUpItsFace) {
  Wound wound(0);
  for (std::uint32_t v = 21 * 21; v < wound.sheet.positions.size(); ++v) wound.sheet.positions[v][1] += 0.003F;
  const Film film = wound.blood(5);
  const auto& rim = *std::ranges::find(wound.pieces, TissueSide::kRim, &TissuePiece::side);
  const auto upwelling = film.vertices.begin() + static_cast<std::ptrdiff_t>(wound.fringe_size() + rim.vertices.size());
  int lips = 0;
  for (std::size_t v = 0; v < rim.vertices.size(); v += 2) {
    const BorderEdge& edge = wound.borders[v / 4];
    const double over_lip = fullness(film.vertices[v % 4 < 2 ? edge.start : edge.end]);
    if (over_lip < kNoCoat) continue;
    ++lips;
    const FilmVertex& outer = upwelling[static_cast<std::ptrdiff_t>(v)];
    const FilmVertex& inner = upwelling[static_cast<std::ptrdiff_t>(v + 1)];
    EXPECT_EQ(outer.position, rim.vertices[v].position);
    EXPECT_NEAR(fullness(outer), over_lip, 1e-5) << "no step at the lip";
    EXPECT_LT(fullness(inner), fullness(outer)) << "less of it the deeper";
  }
  EXPECT_GT(lips, 60);
}

TEST(WoundFilm, StandsBetweenLipsThatLieTogether) {
  Wound wound(0);
  // The pale layer between them would show in single pixels.
  for (const Film& film : {wound.blood(2), wound.bare_edge(1)}) EXPECT_GT(fullness_of_edges(wound, film), 1);
  EXPECT_GT(fullness_of_edges(wound, wound.runoff(1e-6)), 0.3) << "as beside them, where no run begins";
  for (std::uint32_t v = 21 * 21; v < wound.sheet.positions.size(); ++v) wound.sheet.positions[v][1] += 0.003F;
  for (const Film& film : {wound.blood(2), wound.runoff(1e-6), wound.bare_edge(1)}) {
    EXPECT_LT(fullness_of_edges(wound, film), 0.3) << "faces that gape show their layers";
  }
  const Film bare = wound.bare_edge(1);
  const auto of_faces = [&](std::uint32_t corner) { return corner >= wound.fringe_size(); };
  EXPECT_EQ(std::ranges::count_if(bare.corners, of_faces), 4 * 6) << "only at both ends of both lips, which are closed";
}

TEST(WoundFilm, GathersInTheMiddleOfTheGroundOfAWound) {
  Wound wound(0);
  const auto& wall = wound.pieces.front();
  wound.pieces.push_back({.side = TissueSide::kBed, .vertices = wall.vertices, .corners = wall.corners});
  const std::size_t ground = wound.fringe_size() + wound.pieces[1].vertices.size();
  const Film film = wound.blood(5);
  const auto at = [&](std::uint32_t row) { return fullness(film.vertices[ground + row * 21 + 10]); };
  EXPECT_GT(at(10), at(6) + 0.4);
  EXPECT_GT(at(6), 0.5) << "4 mm away";
  EXPECT_LT(at(0), -1) << "10 mm away, where no wound is";
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

/// Metres beyond its lip that blood has come over a level sheet, where the cut gapes by 3 mm.
double beyond_lip(double time, double bleeding) {
  Wound wound(0);
  for (std::uint32_t v = 21 * 21; v < wound.sheet.positions.size(); ++v) wound.sheet.positions[v][1] += 0.003F;
  const Film film = wound.blood(time, bleeding);
  double farthest = 0;
  for (const std::uint32_t corner : film.corners) {
    const FilmVertex& vertex = film.vertices[corner];
    if (vertex.inward > 0) farthest = std::max(farthest, -double{vertex.position[1]});
  }
  return farthest;
}

TEST(WoundFilm, ComesOverALipOfLevelSkinAndCreepsOn) {
  const double early = beyond_lip(0.3, 1), later = beyond_lip(1, 1), late = beyond_lip(2, 1);
  EXPECT_GT(later, early);
  EXPECT_GT(late, later);
  EXPECT_GT(late, 0.0012) << "1.4 mm seen";
  EXPECT_LT(late, 0.0018) << "a pool; twice as long for its width, 2.8 mm, it stands off as a finger";
  EXPECT_LT(beyond_lip(30, 1), 0.0025) << "1.9 mm seen: ever less comes";
  EXPECT_LT(beyond_lip(2, 0), 0.0015) << "of what does not bleed";
}

/// The most fullness of a film where runs begin on lips, the least of them all but for those at an end of the cut.
double fullness_at_feet(const Wound& wound, const Film& film, std::span<const FluidRun> runs) {
  double least = 10;
  for (const FluidRun& run : runs) {
    const WallPlace& start = run.path.front();
    double most = -10, from_end = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(start.weights[k] > 0)) continue;
      most = std::max(most, fullness(film.vertices[start.corners[k]]));
      from_end = std::min(from_end, wound.layout.map.from_end[start.corners[k]]);
    }
    if (from_end >= 0.0015) least = std::min(least, most);
  }
  EXPECT_LT(least, 10) << "no run begins there";
  return least;
}

TEST(WoundFilm, StandsOnTheLipWhereARunBegins) {
  Wound wound(0.8);
  for (std::uint32_t v = 21 * 21; v < wound.sheet.positions.size(); ++v) wound.sheet.positions[v][1] += 0.003F;
  // No gap between wound and run, though the lips gape. Seen: 0.39, at the end of a cut, where all is less; -0.3
  // without.
  EXPECT_GT(fullness_at_feet(wound, wound.blood(2), wound.layout.blood_runs), 0.2);
  EXPECT_GT(fullness_at_feet(wound, wound.runoff(1e-6), wound.layout.fluid_runs), 0.8) << "1.08 was seen, 0.23 without";
}

TEST(WoundFilm, APunctureBleedsLessThanACut) {
  Wound wound(0.8);
  const double cut = lowest(wound.blood(0.5));
  wound.layout.map.length = 0.002;  // of both lips of a hole
  EXPECT_LT(lowest(wound.blood(0.5)), 0.5 * cut);
}

/// Metres, half of the widest run of blood out of a wall, long after the cut.
double widest_run(float thickness) {
  Wound wound(0.8);
  auto topology = std::make_shared<SnapshotTopology>(*wound.sheet.topology);
  topology->thickness.assign(topology->triangles.size(), thickness);
  wound.sheet.topology = topology;
  double widest = 0;
  for (const FilmVertex& vertex : wound.blood(20).vertices) {
    const bool is_run = vertex.lift > 0.0001F;
    if (is_run) widest = std::max(widest, double{vertex.inward});
  }
  return widest;
}

TEST(WoundFilm, ThickWallsBleedInWiderRuns) {
  EXPECT_NEAR(widest_run(0.004F), 2 * widest_run(0.001F), 0.1 * widest_run(0.001F));
  EXPECT_NEAR(widest_run(0.0005F), widest_run(0.001F), 1e-6);
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

/// Metres, of the only run out of a wound whose cut is as long.
double run_width(double cut, double leaked) {
  WoundLayout wounds;
  wounds.fluid_runs.resize(1);
  wounds.fluid_runs[0].chance = 0.5;
  wounds.map.length = 2 * cut;
  return 2 * runoff_section(wounds.fluid_runs[0], wounds, leaked).half_width;
}

TEST(WoundFilm, WhatRunsOutOfAPunctureIsHardlyWiderThanIt) {
  EXPECT_LT(run_width(0.0012, 1e-7), 1.5 * 0.0012);
  EXPECT_NEAR(run_width(0.02, 1e-6), 0.004, 1e-9) << "as what lets go of a wall";
}

TEST(WoundFilm, ALargeLeakRunsWiderThanASmallOne) {
  EXPECT_NEAR(run_width(0.02, 1e-6), 2 * run_width(0.02, 1e-6 / 16), 1e-9) << "by the fourth root";
  EXPECT_GT(run_width(0.0012, 3e-6), 1.2 * run_width(0.0012, 3e-7)) << "also out of a puncture";
  EXPECT_EQ(run_width(0.02, 1), run_width(0.02, 1e-5)) << "or it would run into its neighbours";
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

TEST(WoundFilm, TheWallIsBareAlongTheLipsSoonAfterTheCut) {
  const Wound wound(0);
  const Film film = wound.bare_edge(1);
  const std::uint32_t middle = 10 * 21;
  EXPECT_GT(fullness(film.vertices[middle + 10]), 0.7);
  EXPECT_LE(fullness(film.vertices[middle + 1]), 0) << "an end of the cut";
  EXPECT_LT(fullness(film.vertices[5]), -2) << "far away";
  const Film fresh = wound.bare_edge(0.002);
  EXPECT_LT(fullness(fresh.vertices[middle + 10]), 0) << "it does not come at once";
}

TEST(WoundFilm, LipsThatHaveJustClosedBehindABladeAreALine) {
  Wound wound(0);
  const std::uint32_t middle = 10 * 21 + 10;
  const auto line = [&](double age) { return fullness(wound.bare_edge(age).vertices[middle]); };
  constexpr double kNoise = 0.9;  // of film.glsl, which leaves gaps where there is less
  EXPECT_GT(line(0.06), kNoise) << "two frames after the blade";
  wound.sheet.positions[middle][1] -= 0.003F;
  EXPECT_LT(line(0.06), 0.5 * kNoise) << "of a wound that gapes the faces are seen";
}

TEST(WoundFilm, WhatRunsOutWetsTheLips) {
  const Wound wound(0);
  const std::uint32_t lip = 10 * 21 + 10;
  const auto wet = [&](double leaked) { return fullness(wound.runoff(leaked).vertices[lip]); };
  EXPECT_GT(wet(1e-6), 0.3);
  EXPECT_LT(wet(1e-9), -0.5);
}

TEST(WoundFilm, WhatRunsOutOfTheBodyLeavesOverTheLowerLip) {
  const Wound wound(0.8);
  const Film film = wound.runoff(1e-6);
  const std::uint32_t lower = 10 * 21 + 10;
  std::uint32_t upper = lower;
  for (std::uint32_t v = lower + 1; v < wound.sheet.positions.size(); ++v) {
    if (wound.sheet.positions[v] == wound.sheet.positions[lower]) upper = v;
  }
  EXPECT_GT(fullness(film.vertices[lower]), fullness(film.vertices[upper]) + 0.5);
}

TEST(WoundFilm, WhatRunsOutOfTheBodyWashesBloodAway) {
  const Wound wound(0.8);
  const auto blood = [&](double leaked) {
    return blood_film(wound.sheet, wound.borders, wound.pieces, wound.layout, {.leaked = leaked}, 2);
  };
  const auto runs = [](const Film& film) {
    return std::ranges::count_if(film.vertices, [](const FilmVertex& vertex) { return vertex.kind == kFilmRun; });
  };
  EXPECT_GT(runs(blood(0)), 0);
  EXPECT_EQ(runs(blood(2e-6)), 0);
}

TEST(WoundFilm, BloodOnSkinAndWhatRunsHaveAnEdgeWhileWhatElseLiesOnAWallThinsToNothing) {
  const Wound wound(0.8);
  const auto kinds = [](const Film& film, bool of_runs) {
    std::set<float> values;
    for (const FilmVertex& vertex : film.vertices) {
      if ((vertex.lift > 0.0001F) == of_runs) values.insert(vertex.kind);
    }
    return values;
  };
  const Film blood = wound.blood(1), runoff = wound.runoff(1e-6);
  EXPECT_EQ(kinds(blood, false), (std::set<float>{kFilmCoat, kFilmEdgedCoat}));
  EXPECT_EQ(kinds(runoff, false), std::set<float>{kFilmCoat});
  for (const Film& film : {blood, runoff}) EXPECT_EQ(kinds(film, true), std::set<float>{kFilmRun});
}

TEST(WoundFilm, ItsTrianglesFaceOutwards) {
  const Wound wound(0.8);
  const Film film = wound.blood(4);
  for (std::size_t c = 0; c < film.corners.size(); c += 3) {
    const auto at = [&](std::size_t k) { return vector3(film.vertices[film.corners[c + k]].position); };
    const Vector3 area = cross(at(1) - at(0), at(2) - at(0));
    const Vector3 normal = vector3(film.vertices[film.corners[c]].normal);
    EXPECT_GE(dot(area, normal), -1e-3 * length(area)) << c / 3;
  }
}

TEST(WoundFilm, RunsAreRoundAtBothEnds) {
  const Wound wound(0.8);
  const Film film = wound.blood(4);
  // Rows of four across a run, two of them in the middle: at its first and last one the trail has no width.
  std::size_t ends = 0;
  for (std::size_t v = 1; v + 2 < film.vertices.size(); ++v) {
    const bool is_row = film.vertices[v].lift > 1e-4F && film.vertices[v - 1].inward < 0 &&
                        film.vertices[v + 2].inward < 0 && film.vertices[v].inward >= 0 &&
                        film.vertices[v + 1].inward >= 0;
    if (is_row && film.vertices[v].inward == 0) ++ends;
  }
  EXPECT_EQ(ends, 2 * wound.layout.blood_runs.size());
}

/// The edge of a drop is where `inward` is zero; the shader draws it only where triangles reach beyond.
TEST(WoundFilm, TheDropAtTheEndOfARunIsDrawnWhole) {
  const Film film = Wound(0.8).blood(4);
  std::size_t heads = 0;
  for (std::size_t v = 4; v + 4 < film.vertices.size(); v += 1) {
    const bool is_head = film.vertices[v].lift > 1e-4F && film.vertices[v].inward == 0 &&
                         film.vertices[v - 4].inward > 0 && film.vertices[v - 1].inward < 0;
    if (!is_head) continue;
    ++heads;
    EXPECT_LT(film.vertices[v + 4].inward, 0);
    const Vector3 beyond = vector3(film.vertices[v + 4].position) - vector3(film.vertices[v].position);
    EXPECT_NEAR(length(beyond), 0.0003, 1e-6);
    EXPECT_LT(beyond.z, 0);
  }
  EXPECT_EQ(heads, Wound(0.8).layout.blood_runs.size());
}

TEST(WoundFilm, RunOffNeedsALeak) {
  const Wound wound(0.8);
  EXPECT_TRUE(wound.runoff(0, 5).corners.empty());
  const Film some = wound.runoff(3e-9, 5);
  const Film much = wound.runoff(4e-7, 5);
  EXPECT_GT(lowest(some), 0.001);
  EXPECT_GT(lowest(much), 1.5 * lowest(some));
}

}  // namespace
}  // namespace thinwall
