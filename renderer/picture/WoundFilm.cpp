#include "renderer/picture/WoundFilm.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/picture/RunFilm.hpp"
#include "renderer/wound/Bleeding.hpp"

namespace thinwall {
namespace {

constexpr double kBloodSpacing = 0.0045;  // metres between runs of blood, and of what has been in the body
constexpr double kFluidSpacing = 0.007;
constexpr double kLongestRun = 0.045;     // metres
constexpr double kFirstDrops = 1e-7;      // metres^3, after which lips are wet all along
constexpr float kFringeMargin = 0.0005F;  // metres beyond its edge that are drawn, where blood gathers
constexpr float kOnTriangles = 0.00002F;  // metres, lift of a film on the wall's own triangles

/// What lies along a lip, on the outer side.
struct Fringe {
  double width = 0;   // metres, at its widest
  double height = 0;  // metres
  float beads = 0;    // 0 to 1
};
constexpr Fringe kBlood = {.width = 0.0009, .height = 0.00016, .beads = 1};
constexpr Fringe kWelling = {.width = 0.0016, .height = 0.0004};
constexpr Fringe kBareEdge = {.width = 0.00032, .height = 0.0002};

/// Seconds since a lip was cut; some where the snapshot does not tell.
double age_of(const SnapshotTopology& topology, std::uint32_t vertex, double time) {
  constexpr double kUntold = 3;
  return vertex < topology.cut_times.size() ? std::max(0.0, time - topology.cut_times[vertex]) : kUntold;
}

/// What of its blood a lip has shed, 0 to 1, early on faster than blood_shed: the first drops come at once.
double welled(double age) {
  return 1 - std::exp(-age / 0.5);
}

/// What of a fringe there is at a lip, and how dry that is.
struct FringePart {
  double spread = 0;  // of the width; 0: none
  double dry = 0;     // 0 to 1
};

/// `part_at`: FringePart of a lip's vertex.
template <typename PartAt>
void append_fringe(const SnapshotSurface& surface, const TissuePiece& wall, const WoundLayout& wounds,
                   const Fringe& fringe, const PartAt& part_at, Film& film) {
  const SnapshotTopology& topology = *surface.topology;
  const auto offset = static_cast<std::uint32_t>(film.vertices.size());
  for (std::uint32_t v = 0; v < wall.vertices.size(); ++v) {
    const SurfaceVertex& vertex = wall.vertices[v];
    FilmVertex coat{.position = vertex.position,
                    .normal = vertex.normal,
                    .rest = vertex.rest,
                    .inward = -1,
                    .lift = kOnTriangles,
                    .beads = fringe.beads};
    const std::uint32_t lip = wounds.map.lip[v];
    if (lip != WoundMap::kNoLip) {
      const FringePart part = part_at(lip);
      coat.inward = static_cast<float>(fringe.width * part.spread - wounds.map.from_lip[v]);
      coat.width = static_cast<float>(0.5 * fringe.width);
      coat.height = static_cast<float>(fringe.height);
      coat.dry = static_cast<float>(part.dry);
    }
    film.vertices.push_back(coat);
  }
  for (const Triangle& triangle : topology.triangles) {
    const bool is_near = std::ranges::any_of(
        triangle, [&](std::uint32_t v) { return film.vertices[offset + v].inward > -kFringeMargin; });
    if (!is_near) continue;
    for (const std::uint32_t v : triangle) film.corners.push_back(offset + v);
  }
}

/// On the cut itself, patchy: more of it the deeper, for it runs down there.
void append_rim(const SnapshotTopology& topology, std::span<const BorderEdge> borders, const TissuePiece& rim,
                const WoundLayout& wounds, double bleeding, double time, Film& film) {
  const std::vector<double> tapering = wounds.map.tapering(time);
  const auto offset = static_cast<std::uint32_t>(film.vertices.size());
  for (std::size_t v = 0; v < rim.vertices.size(); ++v) {
    const BorderEdge& edge = borders[v / 4];
    const std::uint32_t lip = v % 4 < 2 ? edge.start : edge.end;
    const SurfaceVertex& vertex = rim.vertices[v];
    FilmVertex coat{.position = vertex.position,
                    .normal = vertex.normal,
                    .rest = vertex.rest,
                    .inward = -1,
                    .lift = kOnTriangles,
                    .beads = 0.2F * kBlood.beads};
    if (wounds.map.lip[lip] == lip) {
      const double age = age_of(topology, lip, time);
      const double amount = bleeding * welled(age) * std::sqrt(tapering[lip]);
      coat.inward = static_cast<float>(0.0004 * amount * (1 + vertex.wound) - 0.00042);
      coat.width = 0.0004F;
      coat.height = static_cast<float>(kBlood.height);
      coat.dry = static_cast<float>(dryness(age));
    }
    film.vertices.push_back(coat);
  }
  for (std::size_t k = 0; k < borders.size(); ++k) {
    if (wounds.map.lip[borders[k].start] != borders[k].start || wounds.map.lip[borders[k].end] != borders[k].end)
      continue;
    for (std::size_t c = 6 * k; c < 6 * k + 6; ++c) film.corners.push_back(offset + rim.corners[c]);
  }
}

/// A run of blood: a thin line at first, that grows wider with what comes after it.
RunShape blood_run(double full_half_width, double volume, double age) {
  constexpr double kDepth = 0.6;      // over half the width
  constexpr double kSlender = 0.05;   // half the width over the length, of a line that has just begun
  constexpr double kLineEnds = 0.02;  // metres, length from which on it ends in a whole drop
  constexpr double kMostDrop = 0.7;   // by which that is wider than the line
  constexpr double kSpeed = 0.03;     // metres/second
  const double half_width = std::min(full_half_width, std::cbrt(kSlender * volume / (2 * kDepth)));
  if (!(half_width > 0)) return {};
  const double height = kDepth * half_width;
  const double length = run_length(volume, 2 * half_width, height, age, kSpeed);
  return {.half_width = half_width,
          .length = length,
          .height = height,
          .dry = dryness(age),
          .drop = 1 + kMostDrop * std::min(1.0, length / kLineEnds)};
}

std::vector<Float3> normals_of(const TissuePiece& wall) {
  std::vector<Float3> normals;
  for (const SurfaceVertex& vertex : wall.vertices) normals.push_back(vertex.normal);
  return normals;
}

double thickness_at(const FluidRun& run, const SnapshotTopology& topology) {
  const std::uint32_t triangle = run.path.front().triangle;
  return triangle < topology.thickness.size() ? topology.thickness[triangle] : 0.001;
}

}  // namespace

WoundLayout lay_out_wounds(const SnapshotTopology& topology, std::span<const BorderEdge> borders,
                           std::span<const char> is_lip, Vector3 down) {
  WoundLayout layout{.map = map_wounds(topology, borders, is_lip),
                     .fall = std::vector<double>(is_lip.size(), 0),
                     .blood_runs = find_runs(topology, borders, is_lip, down, kBloodSpacing, kLongestRun),
                     .fluid_runs = find_runs(topology, borders, is_lip, down, kFluidSpacing, kLongestRun)};
  for (const auto& [start, end, triangle] : borders) {
    if (!is_lip[start] || !is_lip[end]) continue;
    const Vector3 a = vector3(topology.rest_positions[start]), b = vector3(topology.rest_positions[end]);
    for (const std::uint32_t corner : topology.triangles[triangle]) {
      if (corner == start || corner == end) continue;
      const double fall = dot(normalized(vector3(topology.rest_positions[corner]) - 0.5 * (a + b)), down);
      layout.fall[start] += 0.5 * fall;
      layout.fall[end] += 0.5 * fall;
    }
  }
  return layout;
}

Film blood_film(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                std::span<const TissuePiece> pieces, const WoundLayout& wounds, double bleeding, double time) {
  Film film;
  const std::vector<double> tapering = wounds.map.tapering(time);
  const auto shed = [&](std::uint32_t lip) {
    const double age = age_of(*surface.topology, lip, time);
    const double spread = bleeding * welled(age) * tapering[lip] * (1 + 0.5 * wounds.fall[lip]);
    return FringePart{.spread = spread, .dry = dryness(age)};
  };
  append_fringe(surface, pieces.front(), wounds, kBlood, shed, film);
  const auto rim = std::ranges::find(pieces, TissueSide::kRim, &TissuePiece::side);
  if (rim != pieces.end()) append_rim(*surface.topology, borders, *rim, wounds, bleeding, time, film);
  const std::vector<Float3> normals = normals_of(pieces.front());
  for (const FluidRun& run : wounds.blood_runs) {
    const double age = time - run.born - 0.4 * run.chance;
    const double cut_area = kBloodSpacing * thickness_at(run, *surface.topology);
    const double volume = bleeding * (0.5 + run.chance) * cut_area * blood_shed(age);
    append_run(surface, normals, run, blood_run(0.00030 + 0.00025 * run.chance, volume, age), film);
  }
  return film;
}

double runoff_half_width(const FluidRun& run) {
  return 0.0014 + 0.0012 * run.chance;
}

Film runoff_film(const SnapshotSurface& surface, std::span<const TissuePiece> pieces, const WoundLayout& wounds,
                 double leaked, double time) {
  Film film;
  if (!(leaked > 0)) return film;
  const double welling = 1 - std::exp(-leaked / kFirstDrops);
  const std::vector<double> tapering = wounds.map.tapering(time);
  const auto part = [&](std::uint32_t lip) {
    const double spread = welling * tapering[lip] * (0.6 + 0.8 * std::max(0.0, wounds.fall[lip]));
    return FringePart{.spread = spread, .dry = 0};
  };
  append_fringe(surface, pieces.front(), wounds, kWelling, part, film);
  const std::vector<Float3> normals = normals_of(pieces.front());
  for (const FluidRun& run : wounds.fluid_runs) {
    const double half_width = runoff_half_width(run);
    append_run(surface, normals, run,
               {.half_width = half_width,
                .length = run_length(leaked, 2 * half_width, kRunoffHeight, time - run.born, kRunoffSpeed),
                .height = kRunoffHeight,
                .dry = 0,
                .swell = 0.5 * kRunoffSpeed * time},
               film);
  }
  return film;
}

Film bare_edge_film(const SnapshotSurface& surface, std::span<const TissuePiece> pieces, const WoundLayout& wounds,
                    double time) {
  Film film;
  const std::vector<double> tapering = wounds.map.tapering(time);
  const auto part = [&](std::uint32_t lip) { return FringePart{.spread = tapering[lip], .dry = 0}; };
  append_fringe(surface, pieces.front(), wounds, kBareEdge, part, film);
  return film;
}

}  // namespace thinwall
