#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Names of the fields that pictures and ground truth read.
inline constexpr std::string_view kContactPressureField = "contact_pressure";          // pascal, vertices
inline constexpr std::string_view kLargestStressField = "largest_principal_stress";    // pascal, triangles
inline constexpr std::string_view kSmallestStressField = "smallest_principal_stress";  // pascal, triangles

/// Names of a body's scalars that pictures read, behind its name.
inline constexpr std::string_view kPressureScalar = ".pressure";         // pascal, of the first chamber
inline constexpr std::string_view kVolumeScalar = ".volume";             // metres^3, of the cavity
inline constexpr std::string_view kFluidVolumeScalar = ".fluid_volume";  // metres^3, in it
inline constexpr std::string_view kLeakedScalar = ".leaked";             // metres^3, run out

/// The scalar `kind` (one of the names above) of a body, or nothing where the snapshot does not tell it.
std::optional<double> find_scalar(const Snapshot& snapshot, std::string_view body, std::string_view kind);

/// The field of that name and place, or nullptr where the surface has none with a value for each vertex or triangle.
const SnapshotField* find_field(const SnapshotSurface& surface, std::string_view name, FieldLocation location);

/// (triangles), pascal: von Mises' stress of the principal Cauchy stresses a and b of a wall in plane stress,
/// sqrt(a^2 - a b + b^2). Empty where the surface has no stress.
std::vector<float> von_mises_stress(const SnapshotSurface& surface);

/// (triangles), the larger and the smaller principal stretch in the wall's plane, over the stress-free shape that
/// `rest_metric` tells: the square roots of the eigenvalues of M^-1 G with the metrics M at rest and G now.
std::vector<std::array<double, 2>> principal_stretches(const SnapshotSurface& surface);

/// (triangles), metres: thickness of the wall now, which keeps its volume.
std::vector<double> current_thickness(const SnapshotSurface& surface);

}  // namespace thinwall
