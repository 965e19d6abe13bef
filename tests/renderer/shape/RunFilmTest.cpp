#include "renderer/shape/RunFilm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "renderer/snapshot/Vector.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

/// Along x, then aside by `turn` (radians), on a wall of one triangle with corners at 0, 100 mm along x and along y.
FluidRun bent_run(double turn) {
  FluidRun run;
  double x = 0.02, y = 0.02;
  for (int step = 0; step < 24; ++step) {
    const double a = x / 0.1, b = y / 0.1;
    run.path.push_back({.triangle = 0, .corners = {0, 1, 2}, .weights = {1 - a - b, a, b}});
    const double heading = step < 12 ? 0 : turn;
    x += kRunStep * std::cos(heading);
    y += kRunStep * std::sin(heading);
  }
  return run;
}

TEST(RunFilm, RowsDoNotCrossInABend) {
  const SnapshotSurface wall = test::surface_of("wall", {{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0}}, {{0, 1, 2}});
  const std::vector<Float3> normals(3, Float3{0, 0, 1});
  for (const double turn : {-1.2, 1.2}) {
    Film film;
    append_run(wall, normals, bent_run(turn), {.half_width = 0.0014, .length = 0.018, .height = 0.0006}, film);
    ASSERT_FALSE(film.corners.empty());
    for (std::size_t i = 0; i < film.corners.size(); i += 3) {
      const auto corner = [&](std::size_t k) { return vector3(film.vertices[film.corners[i + k]].position); };
      EXPECT_GE(cross(corner(1) - corner(0), corner(2) - corner(0)).z, 0) << "triangle " << i / 3 << ", " << turn;
    }
  }
}

TEST(RunFilm, IsDrawnAsFarOutAsItsEdgeWandersHoweverWideItIs) {
  const SnapshotSurface wall = test::surface_of("wall", {{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0}}, {{0, 1, 2}});
  const std::vector<Float3> normals(3, Float3{0, 0, 1});
  for (const double half_width : {0.0003, 0.0014, 0.0026}) {
    Film film;
    append_run(wall, normals, bent_run(0), {.half_width = half_width, .length = 0.018, .height = 0.0006}, film);
    for (const FilmVertex& vertex : film.vertices) {
      if (!(vertex.inward < 0)) continue;
      // What film.glsl takes of two noises, which seldom go beyond 0.85: 0.55 and 0.10 + 0.00006 / width.
      const double wanders = 0.85 * (0.65 * vertex.width + std::min(0.14 * vertex.width, 0.00006));
      EXPECT_LE(vertex.inward, -wanders) << half_width;
    }
  }
}

TEST(RunFilm, IsDrawnAsFarBeforeTheWallAsRoundWallsRiseOverItsStraightRows) {
  const SnapshotSurface wall = test::surface_of("wall", {{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0}}, {{0, 1, 2}});
  const std::vector<Float3> normals(3, Float3{0, 0, 1});
  for (const double half_width : {0.0003, 0.0014, 0.0032}) {
    Film film;
    append_run(wall, normals, bent_run(0), {.half_width = half_width, .length = 0.018, .height = 0.0006}, film);
    float most = 0;
    for (const FilmVertex& vertex : film.vertices) {
      // The run lies along y = 20 mm.
      const double aside = vertex.position[1] - 0.02, radius = 0.020;
      EXPECT_GE(vertex.lift, 0.95 * (radius - std::sqrt(radius * radius - aside * aside)));
      most = std::max(most, vertex.lift);
    }
    EXPECT_LT(most, 0.0025) << "what lies farther before it hides it";
  }
}

TEST(RunFilm, ItsFrontStandsHigherThanTheFilmBehind) {
  const SnapshotSurface wall = test::surface_of("wall", {{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0}}, {{0, 1, 2}});
  const std::vector<Float3> normals(3, Float3{0, 0, 1});
  const RunShape shape{.half_width = 0.0014, .length = 0.018, .height = 0.0006};
  Film film;
  append_run(wall, normals, bent_run(0), shape, film);
  float front = 0, behind = 0;
  for (const FilmVertex& vertex : film.vertices) {
    // The run begins at 20 mm.
    float& highest = vertex.position[0] > 0.02 + 0.7 * shape.length ? front : behind;
    if (vertex.position[0] < 0.02 + 0.5 * shape.length || &highest == &front)
      highest = std::max(highest, vertex.height);
  }
  // Seen: 3.1; 1.8 where height goes with width.
  EXPECT_GT(front, 2.4 * behind);
}

TEST(RunFilm, ItComesOutOfTheLipWithoutAnEdge) {
  const SnapshotSurface wall = test::surface_of("wall", {{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0}}, {{0, 1, 2}});
  const std::vector<Float3> normals(3, Float3{0, 0, 1});
  Film film;
  append_run(wall, normals, bent_run(0), {.half_width = 0.0014, .length = 0.018, .height = 0.0006}, film);
  std::map<float, float> heights;  // by the way along x
  for (const FilmVertex& vertex : film.vertices) heights[vertex.position[0]] = vertex.height;
  EXPECT_EQ(heights.begin()->second, 0);
  for (const auto& [x, height] : heights) {
    // A tenth of a millimetre hardly tints what lies below; but for that it is seen to come from there.
    if (x < 0.0201F) {
      EXPECT_LT(height, 0.0001F) << x;
    } else if (x > 0.0204F && x < 0.03F) {
      EXPECT_GT(height, 0.0003F) << x;
    }
  }
}

/// Each triangle would slope its own way, which shows as teeth in what the film mirrors.
TEST(RunFilm, TellsHowItSlopesAtItsVertices) {
  const SnapshotSurface wall = test::surface_of("wall", {{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0}}, {{0, 1, 2}});
  const std::vector<Float3> normals(3, Float3{0, 0, 1});
  Film film;
  append_run(wall, normals, bent_run(0), {.half_width = 0.0014, .length = 0.018, .height = 0.0006}, film);
  int compared = 0;
  for (std::size_t i = 0; i < film.corners.size(); i += 3) {
    const auto vertex = [&](std::size_t k) { return film.vertices[film.corners[i + k]]; };
    const Vector3 place = vector3(vertex(0).position);
    // Where it is neither round nor widens.
    if (place.x < 0.024 || place.x > 0.027) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const FilmVertex start = vertex(k), end = vertex((k + 1) % 3);
      const Vector3 way = vector3(end.position) - vector3(start.position);
      const double grown = double{end.inward} - start.inward;
      EXPECT_NEAR(dot(0.5 * (vector3(start.slope) + vector3(end.slope)), way), grown, 5e-6) << place.x;
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}

}  // namespace
}  // namespace thinwall
