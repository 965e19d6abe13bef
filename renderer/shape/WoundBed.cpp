#include "renderer/shape/WoundBed.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "renderer/snapshot/CutOutPieces.hpp"
#include "renderer/snapshot/Float3.hpp"
#include "renderer/snapshot/Vector.hpp"
#include "renderer/wound/RestNormals.hpp"

namespace thinwall {
namespace {

/// Width of the strip that is left out beside borders that have moved, over the depth.
constexpr double kStrip = 2;

/// Metres that a border may be away from its stress-free place for the bed to go on to it.
constexpr double kHeld = 0.0002;

/// How steeply the bed goes down from there.
constexpr double kSteepness = 2;

/// Metres between the lowest part of the sheet and the bed.
constexpr double kGap = 0.001;

/// What the bed gives way to a piece that was cut free, over its depth: at last, and at first.
constexpr double kRoom = 1;
constexpr double kMostRoom = 2;

/// What is left of the room that the bed made at first for a piece, seconds after that was cut free: soon nothing, or
/// the piece would be seen to sink far and to rise again.
double room_left(double age) {
  constexpr double kClosing = 0.12;  // seconds
  const double t = std::clamp(age / kClosing, 0.0, 1.0);
  return 1 - t * t * (3 - 2 * t);
}

/// (vertices), metres below the stress-free sheet to which the bed makes room for a vertex at most.
std::vector<double> most_rooms(const SnapshotTopology& topology, std::span<const std::uint32_t> pieces, double depth,
                               double time) {
  // A piece is free when the last of its border is cut.
  std::vector<double> freed(pieces.size(), kNeverCut);
  for (std::size_t v = 0; v < topology.cut_times.size() && v < pieces.size(); ++v) {
    if (pieces[v] == kHeldPiece) continue;
    freed[pieces[v]] = std::max(freed[pieces[v]], static_cast<double>(topology.cut_times[v]));
  }
  std::vector<double> rooms;
  for (const std::uint32_t piece : pieces) {
    const bool is_held = piece == kHeldPiece;
    const double left = is_held || freed[piece] == kNeverCut ? 0 : room_left(time - freed[piece]);
    rooms.push_back(is_held ? std::numeric_limits<double>::infinity() : depth * (kRoom + (kMostRoom - kRoom) * left));
  }
  return rooms;
}

double most_thickness(const SnapshotTopology& topology) {
  return topology.thickness.empty() ? 0 : *std::ranges::max_element(topology.thickness);
}

/// Metres by which a vertex is below its stress-free place.
double hanging_of(const SnapshotSurface& surface, std::span<const Float3> normals, std::size_t v) {
  return dot(vector3(surface.topology->rest_positions[v]) - vector3(surface.positions[v]), vector3(normals[v]));
}

/// Stress-free places of the sheet's borders that no cut has made.
struct SheetEnds {
  std::vector<Vector3> held;   // where they still are
  std::vector<Vector3> moved;  // and where not
};

SheetEnds ends_of(const SnapshotSurface& surface, std::span<const BorderEdge> borders, std::span<const char> is_lip) {
  SheetEnds ends;
  for (const BorderEdge& edge : borders) {
    if (is_lip[edge.start] && is_lip[edge.end]) continue;
    const Vector3 rest = vector3(surface.topology->rest_positions[edge.start]);
    const bool is_held = length(vector3(surface.positions[edge.start]) - rest) <= kHeld;
    (is_held ? ends.held : ends.moved).push_back(rest);
  }
  return ends;
}

/// Metres to the nearest of `points`; infinite without one.
double nearest(std::span<const Vector3> points, Vector3 place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector3& point : points) nearest = std::min(nearest, length(point - place));
  return nearest;
}

}  // namespace

double bed_depth(const SnapshotSurface& surface, std::span<const BorderEdge> borders, std::span<const char> is_lip,
                 double depth, double time) {
  const SnapshotTopology& topology = *surface.topology;
  const std::vector<Float3> normals = rest_normals(topology);
  const std::vector<std::uint32_t> pieces = cut_out_pieces(topology, borders, is_lip);
  const std::vector<double> rooms = most_rooms(topology, pieces, depth, time);
  double lowest = 0;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    lowest = std::max(lowest, std::min(hanging_of(surface, normals, v), rooms[v]));
  }
  return std::max(depth, lowest + most_thickness(topology) + kGap);
}

std::vector<Float3> laid_on_bed(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                                std::span<const char> is_lip, double below) {
  const SnapshotTopology& topology = *surface.topology;
  const std::vector<std::uint32_t> pieces = cut_out_pieces(topology, borders, is_lip);
  if (std::ranges::all_of(pieces, [](std::uint32_t piece) { return piece == kHeldPiece; })) return surface.positions;
  const std::vector<Float3> normals = rest_normals(topology);
  const double most = below - most_thickness(topology) - kGap;
  std::vector<Float3> positions = surface.positions;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (pieces[v] == kHeldPiece) continue;
    const double deeper = hanging_of(surface, normals, v) - most;
    if (deeper > 0) positions[v] = float3(vector3(positions[v]) + deeper * vector3(normals[v]));
  }
  return positions;
}

TissuePiece wound_bed(const SnapshotSurface& surface, std::span<const BorderEdge> borders, std::span<const char> is_lip,
                      double below) {
  const SnapshotTopology& topology = *surface.topology;
  const SheetEnds ends = ends_of(surface, borders, is_lip);
  TissuePiece bed{.side = TissueSide::kBed, .vertices = {}, .corners = {}};
  if (ends.held.empty() && ends.moved.empty()) return bed;
  const std::vector<Float3> normals = rest_normals(topology);
  const double thickest = most_thickness(topology);
  std::vector<char> is_kept;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vector3 place = vector3(topology.rest_positions[v]);
    const double depth = std::min(below, thickest + kSteepness * nearest(ends.held, place));
    const Float3 position = float3(place - depth * vector3(normals[v]));
    bed.vertices.push_back({.position = position, .normal = normals[v], .rest = topology.rest_positions[v]});
    is_kept.push_back(nearest(ends.moved, place) < kStrip * below ? 0 : 1);
  }
  for (const Triangle& triangle : topology.triangles) {
    if (!std::ranges::all_of(triangle, [&](std::uint32_t v) { return is_kept[v] != 0; })) continue;
    bed.corners.insert(bed.corners.end(), triangle.begin(), triangle.end());
  }
  return bed;
}

WoundBeds lay_on_beds(const Snapshot& snapshot, const LookDefinition& look, std::span<const DrawnTopology> drawn,
                      std::span<const SnapshotSurface> shown) {
  WoundBeds beds{.depths = std::vector<double>(drawn.size(), 0), .laid = {}};
  if (look.data) return beds;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const SnapshotSurface& surface = snapshot.surfaces[k];
    const std::span<const char> is_lip(drawn[k].is_lip.data(), surface.topology->rest_positions.size());
    const auto found = look.bodies.find(surface.body);
    const double depth = found == look.bodies.end() ? TissueLook{}.bed : found->second.bed;
    if (!(depth > 0) || std::ranges::none_of(is_lip, [](char lip) { return lip != 0; })) continue;
    beds.depths[k] = bed_depth(shown[k], drawn[k].borders, drawn[k].is_lip, depth, snapshot.time);
    std::vector<Float3> positions = laid_on_bed(surface, drawn[k].mesh_borders, is_lip, beds.depths[k]);
    if (positions == surface.positions) continue;
    if (!beds.laid) beds.laid = snapshot;
    beds.laid->surfaces[k].positions = std::move(positions);
  }
  return beds;
}

Snapshot laid_on_beds(const Snapshot& snapshot, const LookDefinition& look) {
  std::vector<DrawnTopology> drawn;
  std::vector<SnapshotSurface> shown;
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    drawn.push_back(drawn_topology(surface.topology, drawn_edges(look)));
    shown.push_back(drawn_surface(drawn.back(), surface));
  }
  return lay_on_beds(snapshot, look, drawn, shown).laid.value_or(snapshot);
}

}  // namespace thinwall
