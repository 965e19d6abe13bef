#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "renderer/snapshot/Snapshot.hpp"

/// How a take lies in its HDF5 file, format version 1. Little-endian; SI units, named in the attribute `unit` or in the
/// name; no time stamps, so equal runs give equal bytes. Any name with a `/` has it written as `%2F`; the attribute
/// `name` holds the true one. Groups keep the order of the scenario (creation order).
///
///   /                    attributes: format "thinwall take", format_version 1, program, name, title,
///                        complete 0|1 (whether the run reached its end), state_digest (of the last step)
///   /scenario            text: the scenario as JSON with parameters and defaults filled in
///   /warnings            (warnings) text
///   /time                (steps) float64, seconds
///   /planned_duration    (steps) float64, seconds, as known at that step
///   /gravity             (3) float64, metres/second^2; not in older takes
///   /surfaces/BODY/epoch_0, epoch_1, ...
///                        one for each stretch of steps between changes of topology; attribute first_step, and
///                        scenery (1) where the surface never moves
///     rest_positions     (vertices x 3) float32, metres, stress-free
///     triangles          (triangles x 3) uint32, wall, counter-clockwise seen from outside
///     cap_triangles      (caps x 3) uint32
///     thickness          (triangles) float32, metres, stress-free
///     rest_metric        (triangles x 3) float32, metres^2: see SnapshotTopology; not in older takes
///     cut_times          (vertices) float32, seconds: see SnapshotTopology; only after a cut, not in older takes
///     positions          (steps of the epoch x vertices x 3) float32, metres
///     fields/FIELD       (steps of the epoch x vertices or triangles) float32; attributes unit, location
///   /tools/TOOL          attributes kind (the scenario's word), radius_m, length_m; width_m and thickness_m of a
///   plate,
///                        a scalpel and forceps
///     opening            (steps) float64, metres between the jaws; of forceps only
///     state              (steps x 13) float64: tip 3, direction 3, axis 3 (the frame), depth 1, force 3
///     phase              (steps) text of at most 16 bytes
///   /scalars/SCALAR      (steps) float64; attribute unit
///   /records/tools/TOOL, /records/bodies/BODY
///     values             (steps x columns) float64; attribute columns: the names as in forces.csv and body.csv
///     phase              (steps) text of at most 16 bytes, tools only
///   /captions, /chapters
///     span               (texts x 2) float64, seconds: begin, end
///     text               (texts) text
namespace thinwall::take_layout {

inline constexpr const char* kFormat = "thinwall take";
inline constexpr std::int64_t kFormatVersion = 1;
inline constexpr std::size_t kPhaseBytes = 16;
inline constexpr std::size_t kToolStateColumns = 13;

/// Whether a tool has a width and a thickness.
constexpr bool is_flat(SnapshotToolKind kind) {
  return kind == SnapshotToolKind::kPlate || kind == SnapshotToolKind::kScalpel || kind == SnapshotToolKind::kForceps;
}

/// The name of a group or dataset for a thing called `name`.
inline std::string link_name(const std::string& name) {
  std::string link;
  for (const char letter : name) {
    if (letter == '/') {
      link += "%2F";
    } else {
      link += letter;
    }
  }
  return link == "." ? "%2E" : link;
}

}  // namespace thinwall::take_layout
