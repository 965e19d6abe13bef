#include "renderer/shape/VesselTree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace thinwall {
namespace {

using Matrix3 = std::array<Vector3, 3>;  // rows, symmetric

Vector3 times(const Matrix3& a, Vector3 b) {
  return {dot(a[0], b), dot(a[1], b), dot(a[2], b)};
}

double trace(const Matrix3& a) {
  return a[0].x + a[1].y + a[2].z;
}

/// Of triangles that are spread evenly: area, centroid, and mean square of the distances from it.
struct Moments {
  double area = 0;
  Vector3 centroid;
  Vector3 facing;  // mean normal: of length one for a sheet, zero for a closed wall
  Matrix3 spread;  // metres^2
};

std::array<Vector3, 3> corners_of(const SnapshotTopology& topology, const Triangle& triangle) {
  return {vector3(topology.rest_positions[triangle[0]]), vector3(topology.rest_positions[triangle[1]]),
          vector3(topology.rest_positions[triangle[2]])};
}

void add_product(Vector3 a, double weight, Matrix3& sum) {
  sum[0] = sum[0] + weight * a.x * a;
  sum[1] = sum[1] + weight * a.y * a;
  sum[2] = sum[2] + weight * a.z * a;
}

Moments moments_of(const SnapshotTopology& topology) {
  Moments result;
  for (const Triangle& triangle : topology.triangles) {
    const auto [a, b, c] = corners_of(topology, triangle);
    const Vector3 normal = 0.5 * cross(b - a, c - a);
    result.area += length(normal);
    result.facing = result.facing + normal;
    result.centroid = result.centroid + length(normal) / 3 * (a + b + c);
  }
  if (!(result.area > 0)) return result;
  result.centroid = 1 / result.area * result.centroid;
  result.facing = 1 / result.area * result.facing;
  for (const Triangle& triangle : topology.triangles) {
    const auto [a, b, c] = corners_of(topology, triangle);
    const double weight = 0.5 * length(cross(b - a, c - a)) / (12 * result.area);
    // Exact: of a triangle and of the parts that a cut makes of it the sums are the same.
    add_product(a + b + c - 3 * result.centroid, weight, result.spread);
    for (const Vector3 corner : {a, b, c}) add_product(corner - result.centroid, weight, result.spread);
  }
  return result;
}

/// The direction of the largest spread: of length one, in either sense. Powers of a matrix keep the part of its largest
/// eigenvalue alone. A square sheet or a dome is as wide as long, and which is more hangs on the rounding of each cut:
/// so x is taken for longer than y, and y than z, by more than rounding and less than is seen.
Vector3 longest(Matrix3 spread) {
  constexpr double kPreferred = 1e-4;  // of the trace
  const double preferred = kPreferred * trace(spread);
  spread[0].x += preferred;
  spread[1].y += 0.5 * preferred;
  // By the last power what is so much shorter is gone, to double precision.
  constexpr int kCubings = 12;
  for (int cubing = 0; cubing < kCubings; ++cubing) {
    const double size = trace(spread);
    if (!(size > 0)) return {1, 0, 0};
    for (Vector3& row : spread) row = 1 / size * row;
    spread = {times(spread, spread[0]), times(spread, spread[1]), times(spread, spread[2])};
  }
  return normalized(*std::ranges::max_element(spread, {}, [](Vector3 row) { return length(row); }), {1, 0, 0});
}

/// Positive where the body is fuller on the side of `along`: there is its bulk, and a slender end reaches far the other
/// way.
double fullness(const SnapshotTopology& topology, const Moments& moments, Vector3 along) {
  double cubes = 0;
  for (const Triangle& triangle : topology.triangles) {
    const auto [a, b, c] = corners_of(topology, triangle);
    const double height = dot(1.0 / 3 * (a + b + c) - moments.centroid, along);
    cubes -= 0.5 * length(cross(b - a, c - a)) * height * height * height;
  }
  return cubes;
}

}  // namespace

VesselTree vessel_tree(const SnapshotTopology& topology) {
  const Moments moments = moments_of(topology);
  if (!(trace(moments.spread) > 0)) return {};
  VesselTree tree;
  constexpr double kLong = 1.3;  // to the mean of the other two, from where on a body has a long axis
  tree.along = longest(moments.spread);
  double square = dot(tree.along, times(moments.spread, tree.along));
  if (square < kLong * 0.5 * (trace(moments.spread) - square)) tree.along = {1, 0, 0};
  square = dot(tree.along, times(moments.spread, tree.along));
  const double full = fullness(topology, moments, tree.along);
  // Bodies whose ends are alike, to rounding, must not turn around.
  constexpr double kAlike = 0.02;
  const double least = kAlike * moments.area * square * std::sqrt(square);
  const double leading = tree.along.x + 1e-3 * tree.along.y + 1e-6 * tree.along.z;
  if (std::abs(full) > least ? full < 0 : leading < 0) tree.along = -tree.along;
  tree.across = perpendicular(tree.along);
  const double aside = std::sqrt(trace(moments.spread) - square);
  tree.middle = moments.centroid - 1.5 * aside * moments.facing;
  tree.half_length = std::sqrt(3 * square);
  tree.radius = aside * std::sqrt(1 + 2.25 * dot(moments.facing, moments.facing));
  return tree;
}

double vessel_trunks(const VesselTree& tree, double spacing) {
  constexpr double kBranches = 3;  // of a trunk, side by side, where most of it has branched
  const double around = 2 * std::numbers::pi * tree.radius;
  return std::clamp(std::round(around / (kBranches * spacing)), 2.0, 64.0);
}

}  // namespace thinwall
