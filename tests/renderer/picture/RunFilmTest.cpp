#include "renderer/picture/RunFilm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/picture/Vector.hpp"
#include "tests/renderer/picture/TestMeshes.hpp"

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

}  // namespace
}  // namespace thinwall
