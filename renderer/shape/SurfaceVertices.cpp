#include "renderer/shape/SurfaceVertices.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/snapshot/Float3.hpp"
#include "renderer/snapshot/Vector.hpp"
#include "renderer/wound/VertexNormals.hpp"

namespace thinwall {
namespace {

struct Sums {
  double area = 0;       // of the triangles around
  double rest_area = 0;  // of the triangles around, stress-free
  Vector3 neighbours;    // sum of the neighbours' positions
  double edge_sum = 0;   // sum of the distances to them
  int neighbour_count = 0;
};

std::vector<Sums> sum_over_triangles(const SnapshotSurface& surface) {
  std::vector<Sums> sums(surface.positions.size());
  for (const Triangle& triangle : surface.topology->triangles) {
    Vector3 now[3], rest[3];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      now[corner] = vector3(surface.positions[triangle[corner]]);
      rest[corner] = vector3(surface.topology->rest_positions[triangle[corner]]);
    }
    const double area = 0.5 * length(cross(now[1] - now[0], now[2] - now[0]));
    const double rest_area = 0.5 * length(cross(rest[1] - rest[0], rest[2] - rest[0]));
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vector3 next = now[(corner + 1) % 3] - now[corner];
      const Vector3 previous = now[(corner + 2) % 3] - now[corner];
      Sums& sum = sums[triangle[corner]];
      sum.area += area;
      sum.rest_area += rest_area;
      sum.neighbours = sum.neighbours + now[(corner + 1) % 3] + now[(corner + 2) % 3];
      sum.edge_sum += length(next) + length(previous);
      sum.neighbour_count += 2;
    }
  }
  return sums;
}

/// Blood leaves the small vessels above the capillary closing pressure, about 32 mmHg.
double blanch_of_pressure(double pressure) {
  constexpr double kClosingPressure = 4300;  // Pa
  return std::max(pressure, 0.0) / (std::max(pressure, 0.0) + kClosingPressure);
}

/// Stretched tissue holds the same blood under more area: at twice the area half of the colour is gone.
double blanch_of_stretch(double area_ratio) {
  return area_ratio > 1 ? 1 - 1 / area_ratio : 0.0;
}

const SnapshotField* vertex_field(const SnapshotSurface& surface, const char* name) {
  for (const SnapshotField& field : surface.fields) {
    if (field.name == name && field.location == FieldLocation::kVertex &&
        field.values.size() == surface.positions.size()) {
      return &field;
    }
  }
  return nullptr;
}

/// Twice the mean of the neighbours' rise above the vertex's tangent plane, over the square of their mean distance: on
/// a sphere the neighbours at distance e lie e^2/(2r) below.
double curvature_of(const Sums& sum, Vector3 position, Vector3 normal) {
  if (sum.neighbour_count == 0 || !(sum.edge_sum > 0)) return 0;
  const Vector3 mean = (1.0 / sum.neighbour_count) * sum.neighbours;
  const double edge = sum.edge_sum / sum.neighbour_count;
  return 2 * dot(mean - position, normal) / (edge * edge);
}

/// Half of each value and half of the mean of its neighbours, so that a dent's shade does not end at a single vertex.
std::vector<double> spread(const std::vector<double>& values, const std::vector<Triangle>& triangles) {
  std::vector<double> sums(values.size());
  std::vector<int> counts(values.size());
  for (const Triangle& triangle : triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      sums[triangle[corner]] += values[triangle[(corner + 1) % 3]] + values[triangle[(corner + 2) % 3]];
      counts[triangle[corner]] += 2;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = counts[i] > 0 ? 0.5 * (values[i] + sums[i] / counts[i]) : values[i];
  }
  return sums;
}

}  // namespace

std::vector<SurfaceVertex> wall_vertices(const SnapshotSurface& surface) {
  const std::vector<Sums> sums = sum_over_triangles(surface);
  const std::vector<Vector3> normals = vertex_normals(surface.positions, surface.topology->triangles);
  const SnapshotField* pressure = vertex_field(surface, "contact_pressure");
  std::vector<SurfaceVertex> vertices(surface.positions.size());
  std::vector<double> blanch(vertices.size()), curvature(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double area_ratio = sums[i].rest_area > 0 ? sums[i].area / sums[i].rest_area : 1;
    vertices[i].position = surface.positions[i];
    vertices[i].normal = float3(normals[i]);
    vertices[i].rest = surface.topology->rest_positions[i];
    vertices[i].thickness = static_cast<float>(1 / std::max(area_ratio, 1e-6));
    const double pressed = pressure ? blanch_of_pressure(pressure->values[i]) : 0;
    blanch[i] = 1 - (1 - pressed) * (1 - blanch_of_stretch(area_ratio));
    curvature[i] = curvature_of(sums[i], vector3(surface.positions[i]), normals[i]);
  }
  blanch = spread(blanch, surface.topology->triangles);
  curvature = spread(curvature, surface.topology->triangles);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i].blanch = static_cast<float>(blanch[i]);
    vertices[i].curvature = static_cast<float>(curvature[i]);
  }
  return vertices;
}

std::vector<SurfaceVertex> cap_vertices(const SnapshotSurface& surface) {
  std::vector<SurfaceVertex> vertices;
  vertices.reserve(3 * surface.topology->cap_triangles.size());
  for (const Triangle& triangle : surface.topology->cap_triangles) {
    const Vector3 corner = vector3(surface.positions[triangle[0]]);
    const Float3 normal = float3(normalized(
        cross(vector3(surface.positions[triangle[1]]) - corner, vector3(surface.positions[triangle[2]]) - corner)));
    for (const std::uint32_t vertex : triangle) {
      vertices.push_back(
          {.position = surface.positions[vertex], .normal = normal, .rest = surface.topology->rest_positions[vertex]});
    }
  }
  return vertices;
}

}  // namespace thinwall
