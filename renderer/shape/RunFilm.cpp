#include "renderer/shape/RunFilm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "renderer/snapshot/Float3.hpp"

namespace thinwall {
namespace {

constexpr double kAcrossTriangles = 0.0004;  // metres, lift of a film that does not lie on the wall's own triangles
constexpr double kYoungWidth = 0.22;         // half the width of a trail that has just begun, over its length
constexpr double kSource = 1.5;              // length over which a trail is round where it begins, over half its width
constexpr double kLongestSource = 0.0022;    // metres: a wide one comes from a long lip
constexpr double kWellsUp = 0.0004;          // metres from there, over which it gets its height at most

double source_length(const RunShape& shape) {
  return std::min(kSource * shape.half_width, kLongestSource);
}

/// Half the width `along` a run: a trail that wells out of the lip, where it is round too, and ends in a drop.
double half_width_at(double along, const RunShape& shape) {
  const double drop = shape.drop * shape.half_width;
  const double from_head = shape.length - along;
  const double source = std::clamp(1 - along / source_length(shape), 0.0, 1.0);
  const double swelling = 0.85 + 0.15 * std::cos((along - shape.swell) / 0.0031);
  const double trail = shape.half_width * swelling * std::sqrt(1 - source * source);
  if (from_head >= 4 * drop) return trail;
  const double into_drop = std::clamp((4 * drop - from_head) / (3 * drop), 0.0, 1.0);
  const double body = trail + (drop - trail) * into_drop * into_drop * (3 - 2 * into_drop);
  const double round = std::clamp(1 - from_head / drop, 0.0, 1.0);
  return body * std::sqrt(1 - round * round);
}

/// Where rows of vertices go across a run, metres along it: close together where its ends are round.
std::vector<double> rows_along(const RunShape& shape) {
  constexpr int kRoundRows = 6;
  const auto rounded = [](int row) { return 1 - std::cos(0.5 * std::numbers::pi * row / kRoundRows); };
  const double source = std::min(source_length(shape), 0.5 * shape.length);
  const double head = std::min(shape.drop * shape.half_width, 0.5 * shape.length);
  std::vector<double> rows;
  for (int row = 0; row < kRoundRows; ++row) rows.push_back(source * rounded(row));
  // Twice as fine as the path.
  const double trail = shape.length - head - source;
  const int steps = std::max(1, static_cast<int>(std::ceil(trail / (0.5 * kRunStep))));
  for (int step = 0; step < steps; ++step) rows.push_back(source + trail * step / steps);
  for (int row = kRoundRows; row > 0; --row) rows.push_back(shape.length - head * rounded(row));
  rows.push_back(shape.length);
  return rows;
}

/// A path on the wall as it is now, and at rest.
struct RunCourse {
  const SnapshotSurface& surface;
  std::span<const Float3> normals;
  const FluidRun& run;

  Vector3 at(double along, std::span<const Float3> points) const {
    const std::size_t steps = run.path.size() - 1;
    const double place = std::clamp(along / kRunStep, 0.0, static_cast<double>(steps));
    const auto first = std::min(static_cast<std::size_t>(place), steps - 1);
    const double part = place - static_cast<double>(first);
    return (1 - part) * point_at(run.path[first], points) + part * point_at(run.path[first + 1], points);
  }
};

/// How the half width of a run grows along it, which its round ends would have without bound.
double widening_at(double along, const RunShape& shape) {
  constexpr double kStep = 0.0001;  // metres
  constexpr double kMost = 2;
  const double before = std::max(0.0, along - kStep), behind = std::min(shape.length, along + kStep);
  return std::clamp((half_width_at(behind, shape) - half_width_at(before, shape)) / (behind - before), -kMost, kMost);
}

/// Part of a trail's height at its source, where it comes out of the lip: from nothing, so that it begins without an
/// edge.
double welled_up(double along, const RunShape& shape) {
  const double t = std::min(1.0, along / std::min(shape.half_width, kWellsUp));
  return t * t * (3 - 2 * t);
}

/// Metres beyond the edge of a row that are drawn. The edge wanders, as film.glsl has it, by a part of the width.
double margin_of(double half_width) {
  constexpr double kWanders = 0.57, kFinely = 0.00005;  // over half the width and metres more, at most
  return std::max(kFilmMargin, kWanders * half_width + kFinely);
}

/// Metres by which a row that reaches so far to either side is drawn in front of the wall: it is straight, and walls
/// are round, though hardly more than this.
double lift_of(double reach) {
  constexpr double kRound = 0.020;  // metres, radius
  return std::max(kAcrossTriangles, reach * reach / (2 * kRound));
}

/// The middle of a row belongs to both its sides, on each of which the film slopes its own way.
constexpr std::array kColumns = {-1.0, -0.0, 0.0, 1.0};

/// Vertices of the columns across the run at `along`, `ahead` of there by metres.
void append_row(const RunCourse& course, const RunShape& shape, double along, double ahead, Film& film) {
  const std::vector<Float3>& now = course.surface.positions;
  const Vector3 normal = normalized(course.at(along, course.normals));
  // As far as it is wide: in a sharper bend rows would cross.
  const double half = half_width_at(along, shape), reach = std::max(kRunStep, 1.5 * shape.half_width);
  const double before = std::max(0.0, along - reach), behind = std::min(shape.length, along + reach);
  const Vector3 sense = normalized(course.at(behind, now) - course.at(before, now));
  const Vector3 side = normalized(cross(normal, sense));
  const Vector3 middle = course.at(along, now) + ahead * sense;
  const Vector3 rest = course.at(along, course.surface.topology->rest_positions) + ahead * sense;
  const double widening = widening_at(along, shape), over_trail = half / shape.half_width;
  // A drop stands higher than it is wider; at the source it is as steep as elsewhere.
  const double height = shape.height * over_trail * std::max(1.0, over_trail) * welled_up(along, shape);
  const double margin = ahead == 0 ? margin_of(half) : kFilmMargin;
  for (const double across : kColumns) {
    const double out = across * (half + margin);
    const Vector3 slope = widening * sense - std::copysign(1.0, across) * side;
    film.vertices.push_back({.position = float3(middle + out * side + 0.0001 * normal),
                             .normal = float3(normal),
                             .rest = float3(rest + out * side),
                             .inward = static_cast<float>(across == 0 && ahead == 0 ? half : -margin),
                             .width = static_cast<float>(std::max(half, 1e-5)),
                             .height = static_cast<float>(height),
                             .dry = static_cast<float>(shape.dry),
                             .lift = static_cast<float>(lift_of(half + margin)),
                             .slope = float3(slope)});
  }
}

}  // namespace

void append_run(const SnapshotSurface& surface, std::span<const Float3> normals, const FluidRun& run,
                const RunShape& shape, Film& film) {
  RunShape drawn = shape;
  drawn.length = std::min(shape.length, static_cast<double>(run.path.size() - 1) * kRunStep);
  if (drawn.length < kRunStep) return;
  // A run begins as a drop that grows.
  drawn.half_width = std::min(shape.half_width, kYoungWidth * drawn.length);
  drawn.height = shape.height * drawn.half_width / shape.half_width;
  const RunCourse course{.surface = surface, .normals = normals, .run = run};
  const auto first = static_cast<std::uint32_t>(film.vertices.size());
  for (const double along : rows_along(drawn)) append_row(course, drawn, along, 0, film);
  // What lies before the drop, so that its edge is drawn whole.
  append_row(course, drawn, drawn.length, kFilmMargin, film);
  const auto end = static_cast<std::uint32_t>(film.vertices.size());
  constexpr auto kStride = static_cast<std::uint32_t>(kColumns.size());
  for (std::uint32_t row = first; row + kStride < end; row += kStride) {
    // The two middle columns lie at the same places.
    for (const std::uint32_t a : {row, row + 2}) {
      const std::uint32_t b = a + kStride;
      for (const std::uint32_t corner : {a, b + 1, a + 1, a, b, b + 1}) film.corners.push_back(corner);
    }
  }
}

}  // namespace thinwall
