#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "renderer/image/PictureCorner.hpp"
#include "renderer/look/DataScale.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// What colours can show of a wall instead of its tissue.
enum class DataQuantity {
  kLargestStress,    // pascal, larger principal Cauchy stress in the wall's plane
  kSmallestStress,   // pascal, smaller principal Cauchy stress in the wall's plane
  kVonMisesStress,   // pascal
  kStrain,           // larger principal stretch less one
  kThickness,        // metres, now
  kContactPressure,  // pascal
  kDisplacement      // metres, from the stress-free place
};

/// A row of the table of quantities.
struct DataQuantityRow {
  DataQuantity quantity;
  std::string_view word;   // of the scenario format
  std::string_view title;  // of the legend
  std::string_view unit;   // SI
  std::string_view documentation;
};

/// All quantities.
std::span<const DataQuantityRow> data_quantities();

/// The quantity of that word, or nullptr.
const DataQuantityRow* find_data_quantity(std::string_view word);

const DataQuantityRow& row_of(DataQuantity quantity);

/// A quantity and what the ends of the colours stand for, in its unit. An end that is absent follows from
/// the whole take.
struct DataView {
  DataQuantity quantity = DataQuantity::kVonMisesStress;
  std::optional<double> from = {};
  std::optional<double> to = {};
  DataScale scale = DataScale::kLinear;
  bool goes_on_below = false;  // the wall has more beyond the ends, in their colours
  bool goes_on_above = false;
  std::optional<PictureCorner> legend = {};  // where it stands; where it covers least of what is done when absent
};

/// (vertices), in the quantity's unit; what belongs to triangles as the mean of those around, weighted by their area at
/// rest. Throws PictureFailure when the surface does not hold what it takes.
std::vector<float> data_values(const SnapshotSurface& surface, DataQuantity quantity);

}  // namespace thinwall
