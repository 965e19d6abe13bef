#include "renderer/look/DataView.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/snapshot/SurfaceFields.hpp"

namespace thinwall {
namespace {

constexpr std::array<DataQuantityRow, 7> kRows = {
    {{DataQuantity::kVonMisesStress, "von_mises_stress", "Von Mises stress", "Pa",
      "von Mises' stress in the middle plane of the wall"},
     {DataQuantity::kLargestStress, "largest_stress", "Largest stress", "Pa",
      "the larger principal Cauchy stress in the wall's plane"},
     {DataQuantity::kSmallestStress, "smallest_stress", "Smallest stress", "Pa",
      "the smaller principal Cauchy stress in the wall's plane"},
     {DataQuantity::kStrain, "strain", "Largest strain", "",
      "the larger principal stretch in the wall's plane, less one"},
     {DataQuantity::kThickness, "thickness", "Thickness", "m", "thickness of the wall now"},
     {DataQuantity::kContactPressure, "contact_pressure", "Contact pressure", "Pa", "pressure between wall and tools"},
     {DataQuantity::kDisplacement, "displacement", "Displacement", "m", "distance from the stress-free place"}}};

double distance(const Float3& a, const Float3& b) {
  return std::hypot(static_cast<double>(a[0]) - b[0], static_cast<double>(a[1]) - b[1],
                    static_cast<double>(a[2]) - b[2]);
}

double rest_area(const SnapshotTopology& topology, std::size_t triangle) {
  const auto& [a, b, c] = topology.triangles[triangle];
  const double u = distance(topology.rest_positions[a], topology.rest_positions[b]);
  const double v = distance(topology.rest_positions[b], topology.rest_positions[c]);
  const double w = distance(topology.rest_positions[c], topology.rest_positions[a]);
  const double half = 0.5 * (u + v + w);  // Heron
  return std::sqrt(std::max(0.0, half * (half - u) * (half - v) * (half - w)));
}

template <typename Number>
std::vector<float> at_vertices(const SnapshotSurface& surface, const std::vector<Number>& of_triangles) {
  std::vector<double> sums(surface.positions.size()), areas(surface.positions.size());
  for (std::size_t t = 0; t < of_triangles.size(); ++t) {
    const double area = rest_area(*surface.topology, t);
    for (const std::uint32_t vertex : surface.topology->triangles[t]) {
      sums[vertex] += area * of_triangles[t];
      areas[vertex] += area;
    }
  }
  std::vector<float> values;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    values.push_back(areas[v] > 0 ? static_cast<float>(sums[v] / areas[v]) : 0.0F);
  }
  return values;
}

[[noreturn]] void fail(const SnapshotSurface& surface, DataQuantity quantity) {
  throw PictureFailure("the snapshot of body `" + surface.body + "` does not hold what " +
                       std::string(row_of(quantity).word) +
                       " takes: an older version of this program made it; run the scenario again");
}

std::vector<float> field_of(const SnapshotSurface& surface, DataQuantity quantity, std::string_view name,
                            FieldLocation location) {
  const SnapshotField* field = find_field(surface, name, location);
  if (field == nullptr) fail(surface, quantity);
  return location == FieldLocation::kVertex ? field->values : at_vertices(surface, field->values);
}

std::vector<float> strains(const SnapshotSurface& surface) {
  std::vector<double> strain;
  for (const auto& stretches : principal_stretches(surface)) strain.push_back(stretches[0] - 1);
  return at_vertices(surface, strain);
}

std::vector<float> displacements(const SnapshotSurface& surface) {
  std::vector<float> values;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    values.push_back(static_cast<float>(distance(surface.positions[v], surface.topology->rest_positions[v])));
  }
  return values;
}

}  // namespace

std::span<const DataQuantityRow> data_quantities() {
  return kRows;
}

const DataQuantityRow* find_data_quantity(std::string_view word) {
  const auto row = std::ranges::find(kRows, word, &DataQuantityRow::word);
  return row == kRows.end() ? nullptr : &*row;
}

const DataQuantityRow& row_of(DataQuantity quantity) {
  return *std::ranges::find(kRows, quantity, &DataQuantityRow::quantity);
}

std::vector<float> data_values(const SnapshotSurface& surface, DataQuantity quantity) {
  const bool has_rest = surface.topology->rest_metric.size() == surface.topology->triangles.size();
  switch (quantity) {
    case DataQuantity::kLargestStress:
      return field_of(surface, quantity, kLargestStressField, FieldLocation::kTriangle);
    case DataQuantity::kSmallestStress:
      return field_of(surface, quantity, kSmallestStressField, FieldLocation::kTriangle);
    case DataQuantity::kContactPressure:
      return field_of(surface, quantity, kContactPressureField, FieldLocation::kVertex);
    case DataQuantity::kVonMisesStress: {
      const std::vector<float> stress = von_mises_stress(surface);
      if (stress.empty()) fail(surface, quantity);
      return at_vertices(surface, stress);
    }
    case DataQuantity::kStrain:
      if (!has_rest) fail(surface, quantity);
      return strains(surface);
    case DataQuantity::kThickness:
      if (!has_rest) fail(surface, quantity);
      return at_vertices(surface, current_thickness(surface));
    case DataQuantity::kDisplacement:
      break;
  }
  return displacements(surface);
}

}  // namespace thinwall
