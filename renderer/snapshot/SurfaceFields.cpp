#include "renderer/snapshot/SurfaceFields.hpp"

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

using Metric = std::array<double, 3>;  // of the edges from the first corner: 11, 22, 12

Metric metric_of(const Triangle& triangle, const std::vector<Float3>& positions) {
  Double3 u{}, v{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    u[axis] = static_cast<double>(positions[triangle[1]][axis]) - positions[triangle[0]][axis];
    v[axis] = static_cast<double>(positions[triangle[2]][axis]) - positions[triangle[0]][axis];
  }
  const auto dot = [](const Double3& a, const Double3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  return {dot(u, u), dot(v, v), dot(u, v)};
}

double determinant(const Metric& metric) {
  return metric[0] * metric[1] - metric[2] * metric[2];
}

}  // namespace

const SnapshotField* find_field(const SnapshotSurface& surface, std::string_view name, FieldLocation location) {
  const std::size_t size =
      location == FieldLocation::kVertex ? surface.positions.size() : surface.topology->triangles.size();
  const auto found = std::ranges::find_if(surface.fields, [&](const SnapshotField& field) {
    return field.name == name && field.location == location && field.values.size() == size;
  });
  return found == surface.fields.end() ? nullptr : &*found;
}

std::optional<double> find_scalar(const Snapshot& snapshot, std::string_view body, std::string_view kind) {
  for (const SnapshotScalar& scalar : snapshot.scalars) {
    const std::string_view name = scalar.name;
    if (name.size() == body.size() + kind.size() && name.starts_with(body) && name.ends_with(kind)) return scalar.value;
  }
  return std::nullopt;
}

std::vector<float> von_mises_stress(const SnapshotSurface& surface) {
  const SnapshotField* largest = find_field(surface, kLargestStressField, FieldLocation::kTriangle);
  const SnapshotField* smallest = find_field(surface, kSmallestStressField, FieldLocation::kTriangle);
  std::vector<float> stress;
  if (largest == nullptr || smallest == nullptr) return stress;
  for (std::size_t t = 0; t < largest->values.size(); ++t) {
    const double a = largest->values[t], b = smallest->values[t];
    stress.push_back(static_cast<float>(std::sqrt(a * a - a * b + b * b)));
  }
  return stress;
}

std::vector<std::array<double, 2>> principal_stretches(const SnapshotSurface& surface) {
  const SnapshotTopology& topology = *surface.topology;
  const bool has_metric = topology.rest_metric.size() == topology.triangles.size();
  std::vector<std::array<double, 2>> stretches;
  for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
    Metric rest;
    if (has_metric) {
      std::ranges::copy(topology.rest_metric[t], rest.begin());
    } else {
      rest = metric_of(topology.triangles[t], topology.rest_positions);
    }
    const Metric now = metric_of(topology.triangles[t], surface.positions);
    const double half_trace = 0.5 * (rest[1] * now[0] + rest[0] * now[1] - 2 * rest[2] * now[2]) / determinant(rest);
    const double product = determinant(now) / determinant(rest);
    const double half_difference = std::sqrt(std::max(0.0, half_trace * half_trace - product));
    const double larger = std::sqrt(half_trace + half_difference);
    stretches.push_back({larger, std::sqrt(std::max(0.0, product)) / larger});
  }
  return stretches;
}

std::vector<double> current_thickness(const SnapshotSurface& surface) {
  std::vector<double> thickness;
  for (const auto& [larger, smaller] : principal_stretches(surface)) {
    thickness.push_back(surface.topology->thickness[thickness.size()] / (larger * smaller));
  }
  return thickness;
}

}  // namespace thinwall
