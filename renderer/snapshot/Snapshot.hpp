#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace thinwall {

using Float3 = std::array<float, 3>;
using Double3 = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

/// What stays the same from snapshot to snapshot while no cut changes a surface; shared between snapshots.
struct SnapshotTopology {
  std::vector<Float3> rest_positions;   // (vertices x 3), metres, stress-free
  std::vector<Triangle> triangles;      // (triangles x 3), wall, counter-clockwise seen from outside
  std::vector<Triangle> cap_triangles;  // (caps x 3)
  std::vector<float> thickness;         // (triangles), metres, stress-free
  // (triangles x 3) or none, metres^2: products 11, 22, 12 of the edges from the first corner to the second and third,
  // of the shape in which the triangle bears no stress. It differs from `rest_positions` under prestretch.
  std::vector<Float3> rest_metric = {};
  // (vertices) or none, seconds: when the vertex came to lie at a cut, kNeverCut where it does not. See cut_times().
  std::vector<float> cut_times = {};
  bool is_scenery = false;  // held as a whole: cameras, tools and light go by the other surfaces
};

/// Cut time of a vertex that lies at no cut.
inline constexpr float kNeverCut = -1;

enum class FieldLocation { kVertex, kTriangle };

struct SnapshotField {
  std::string name;  // "contact_pressure", "mean_stress", ...
  std::string unit;  // SI, "Pa"
  FieldLocation location = FieldLocation::kVertex;
  std::vector<float> values;  // (vertices) or (triangles), in `unit`
};

struct SnapshotSurface {
  std::string body;
  std::shared_ptr<const SnapshotTopology> topology;
  std::vector<Float3> positions;  // (vertices x 3), metres
  std::vector<SnapshotField> fields;
};

enum class SnapshotToolKind { kPoint, kLine, kSphere, kCapsule, kPlate, kNeedle, kScalpel, kForceps };

/// Their names, in that order.
inline constexpr auto kSnapshotToolKindNames =
    std::to_array<std::string_view>({"point", "line", "sphere", "capsule", "plate", "needle", "scalpel", "forceps"});

struct SnapshotTool {
  std::string name;
  SnapshotToolKind kind = SnapshotToolKind::kPoint;
  double radius = 0;               // metres; sphere, capsule, needle
  double length = 0;               // metres; line, capsule, plate (along y'), needle, scalpel, forceps
  double width = 0;                // metres; plate (along x'), scalpel, forceps (along y')
  double thickness = 0;            // metres; plate, scalpel, each jaw of forceps
  double opening = 0;              // metres between the jaws of forceps
  Double3 tip = {0, 0, 0};         // metres
  Double3 direction = {0, 0, -1};  // z', unit: the sense of motion into the body
  Double3 axis = {0, 1, 0};        // y', unit
  std::string phase = "idle";
  double depth = 0;           // metres of travel along the direction since first contact, 0 before
  Double3 force = {0, 0, 0};  // newton, what the tissue does to the tool
  bool is_set_aside = false;  // out of the picture: not drawn, nor in its ground truth
  bool touches() const { return force != Double3{0, 0, 0}; }
};

struct SnapshotScalar {
  std::string name;  // "organ.pressure", ...
  std::string unit;  // SI
  double value = 0;
};

/// One moment of a simulation: all that the renderer gets and all that a take stores.
struct Snapshot {
  double time = 0;              // seconds
  Double3 gravity = {0, 0, 0};  // metres / second^2
  std::vector<SnapshotSurface> surfaces;
  std::vector<SnapshotTool> tools;
  std::vector<SnapshotScalar> scalars;
};

/// The moment between two consecutive snapshots at time `time` (clamped to theirs): positions, poses, fields and
/// scalars linear in time (directions brought back to length one). The phase is that of the nearer snapshot, halfway
/// that of the earlier one: time steps such as 16.6667 ms end a little after the frame that shows them. Where a cut has
/// changed a surface in between, it is there at once, and opens from then on (carried_over of CarriedSurface.hpp). The
/// ends give the snapshots themselves, to the last bit; of two at one time the earlier one is given. Throws
/// std::invalid_argument, naming what differs, when bodies, fields, tools or scalars are not the same in both.
Snapshot interpolate(const Snapshot& earlier, const Snapshot& later, double time);

}  // namespace thinwall
