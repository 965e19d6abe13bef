#include "renderer/shape/WoundFilm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "renderer/shape/BloodRun.hpp"
#include "renderer/shape/RunFilm.hpp"
#include "renderer/shape/WoundCoat.hpp"
#include "renderer/snapshot/Float3.hpp"
#include "renderer/wound/Bleeding.hpp"

namespace thinwall {
namespace {

constexpr double kBloodFrom = 0.009;      // metres of a lip whose blood goes into a run; the rest stays in the wound
constexpr double kFirstDrops = 1e-7;      // metres^3, after which lips are wet all along
constexpr float kFringeMargin = 0.0005F;  // metres beyond its edge that are drawn, for that is uneven

/// What lies along a lip, on the outer side.
struct Fringe {
  double width = 0;   // metres, at its widest; of a coat, over which its fullness falls by one
  double height = 0;  // metres
  double spare = 0;   // fullness that a coat lacks at the lip itself: the more, the fewer places it reaches
  float kind = kFilmRun;
};
/// Blood stays in a wound that gapes but for the few places where it comes over the lip; closed lips leave it no room.
constexpr Fringe kBlood = {.width = 0.0012, .height = 0.0009, .spare = 1.1, .kind = kFilmEdgedCoat};
constexpr Fringe kWelling = {.width = 0.0012, .height = 0.0004, .spare = 0.6, .kind = kFilmCoat};
constexpr Fringe kBareEdge = {.width = 0.00025, .height = 0.0001, .spare = 0.2, .kind = kFilmCoat};

constexpr double kBloodFoot = 1.3, kFluidFoot = 1.1;  // spread that a lip has more where a run begins

constexpr double kPressedOut = 0.75;  // fullness that closed lips have more
constexpr double kLipRoom = 0.0010;   // metres between lips, by which a third of that is left

/// Blood on the faces of a cut: they bleed below the outermost layer, and it runs down them. And on the ground of the
/// wound, where it gathers along the middle, which is deepest.
constexpr double kFaceTop = 0.10, kFaceGrowth = 1.10;  // fullness outside, and what is added to the inside
constexpr double kLowerLip = 0.35;                     // and what to a lip from which the wall falls away
constexpr double kBetweenLips = 1.3;                   // and what to lips that lie together, between which it stands
constexpr double kBridged = 0.0002;                    // metres between lips, by which a third of that is left
constexpr double kGround = 0.55, kGroundMiddle = 0.9;  // fullness all over the ground, and what is added in the middle
constexpr double kMiddle = 0.004;                      // metres, half the width of that
constexpr double kGroundEnds = 0.009;                  // metres from the cut, about where there is none any more
constexpr double kFaceHeight = 0.00016;                // metres, where the fullness is about one

/// Seconds since a lip was cut; some where the snapshot does not tell.
double age_of(const SnapshotTopology& topology, std::uint32_t vertex, double time) {
  constexpr double kUntold = 3;
  return vertex < topology.cut_times.size() ? std::max(0.0, time - topology.cut_times[vertex]) : kUntold;
}

/// What of its blood a lip has shed, 0 to 1, early on faster than blood_shed: the first drops come at once.
double welled(double age) {
  return 1 - std::exp(-age / 0.35);
}

/// What of a fringe there is at a lip, and how dry that is.
struct FringePart {
  double spread = 0;  // of the width; 0: none
  double dry = 0;     // 0 to 1
};

/// A vertex of a film that lies on the wall's own triangles.
FilmVertex fringe_vertex(const Fringe& fringe, const Float3& position, const Float3& normal, const Float3& rest) {
  return {.position = position,
          .normal = normal,
          .rest = rest,
          .inward = -1,
          .width = static_cast<float>(fringe.kind == kFilmRun ? 0.5 * fringe.width : fringe.width),
          .height = static_cast<float>(fringe.height),
          .lift = kOnTriangles,
          .kind = fringe.kind};
}

/// On the wall's vertices, and on the points between them.
std::vector<FilmVertex> fringe_vertices(const TissuePiece& wall, const FringeMesh& mesh, const Fringe& fringe) {
  std::vector<FilmVertex> vertices;
  vertices.reserve(wall.vertices.size() + mesh.points.size());
  for (const SurfaceVertex& vertex : wall.vertices) {
    vertices.push_back(fringe_vertex(fringe, vertex.position, vertex.normal, vertex.rest));
  }
  for (const FringeMesh::Point& point : mesh.points) {
    const SurfaceVertex &a = wall.vertices[point.start], &b = wall.vertices[point.end];
    const auto between = [&](const Float3& from, const Float3& to) {
      return (1 - point.part) * vector3(from) + point.part * vector3(to);
    };
    vertices.push_back(fringe_vertex(fringe, float3(between(a.position, b.position)),
                                     float3(normalized(between(a.normal, b.normal), vector3(a.normal))),
                                     float3(between(a.rest, b.rest))));
  }
  return vertices;
}

/// How a fringe grows towards the lip that it comes from: by the way at rest for that which the wall has now. At the
/// lip itself it is level.
Vector3 slope_at(const TissuePiece& wall, const Float3& position, const NearLip& lip) {
  const Vector3 start = vector3(wall.vertices[lip.start].position), end = vector3(wall.vertices[lip.end].position);
  const Vector3 way = start + lip.along * (end - start) - vector3(position);
  return (lip.distance / std::max(dot(way, way), 1e-14)) * way;
}

/// `part_at`: FringePart of a lip's vertex.
template <typename PartAt>
void append_fringe(const TissuePiece& wall, const WoundLayout& wounds, const Fringe& fringe, const PartAt& part_at,
                   Film& film) {
  const double margin = fringe.kind == kFilmRun ? kFringeMargin : -kNoCoat * fringe.width;
  const auto offset = static_cast<std::uint32_t>(film.vertices.size());
  for (const FilmVertex& vertex : fringe_vertices(wall, wounds.fringe, fringe)) film.vertices.push_back(vertex);
  std::vector<FringePart> parts(wall.vertices.size());
  std::vector<double> reach(wall.vertices.size(), 0);
  for (std::uint32_t v = 0; v < parts.size(); ++v) {
    if (wounds.map.lip[v] != v) continue;
    parts[v] = part_at(v);
    reach[v] = fringe.width * (parts[v].spread - fringe.spare);
  }
  for (std::uint32_t v = 0; v + 1 < wounds.fringe.first_lip.size(); ++v) {
    const FringeSpread spread = spread_at(wounds.fringe, v, reach);
    if (spread.lip == nullptr) continue;
    FilmVertex& layer = film.vertices[offset + v];
    const FringePart &start = parts[spread.lip->start], &end = parts[spread.lip->end];
    const double along = spread.lip->along, amount = std::lerp(start.spread, end.spread, along);
    layer.inward = static_cast<float>(spread.beyond);
    layer.slope = float3(slope_at(wall, layer.position, *spread.lip));
    layer.dry = static_cast<float>(std::lerp(start.dry, end.dry, along));
    // What has an edge is seen wherever it is, so it wells up from nothing.
    if (fringe.kind == kFilmEdgedCoat) layer.height *= static_cast<float>(std::min(1.0, amount * amount));
  }
  for (const Triangle& triangle : wounds.fringe.triangles) {
    const bool is_near =
        std::ranges::any_of(triangle, [&](std::uint32_t v) { return film.vertices[offset + v].inward > -margin; });
    if (!is_near) continue;
    for (const std::uint32_t v : triangle) film.corners.push_back(offset + v);
  }
}

/// What has welled up of a lip's blood at its place, 0 to about 1.
struct Shed {
  std::vector<double> amount;  // (vertices), of lips
  std::vector<double> dry;     // (vertices), of lips
};

Shed shed_blood(const SnapshotTopology& topology, const WoundLayout& wounds, double bleeding, double time) {
  const std::vector<double> tapering = wounds.map.tapering(time);
  Shed shed{.amount = std::vector<double>(tapering.size(), 0), .dry = std::vector<double>(tapering.size(), 0)};
  for (std::uint32_t v = 0; v < tapering.size(); ++v) {
    if (wounds.map.lip[v] != v) continue;
    const double age = age_of(topology, v, time);
    shed.amount[v] = std::cbrt(bleeding) * welled(age) * std::sqrt(tapering[v]);
    shed.dry[v] = dryness(age);
  }
  return shed;
}

/// `gapes`: what lip_gapes gives.
FaceCoat blood_on_faces(const WoundLayout& wounds, std::span<const double> gapes, const Shed& shed) {
  FaceCoat coat{.height = kFaceHeight, .outside = shed.amount, .inside = shed.amount, .dry = shed.dry};
  for (std::size_t v = 0; v < gapes.size(); ++v) {
    const double between = kBetweenLips * std::exp(-gapes[v] / kBridged);
    const double most = kFaceTop + kLowerLip * wounds.fall[v] + between;
    coat.outside[v] = shed.amount[v] * (1 + most) - 1;
    coat.inside[v] = shed.amount[v] * (1 + most + kFaceGrowth) - 1;
  }
  return coat;
}

/// On the faces of a cut what goes with a fringe along its lips. `part_at`: FringePart of a lip's vertex;
/// `fullness_at`: of that vertex and that part, at the outer and the inner edge of the face.
template <typename PartAt, typename FullnessAt>
void append_with_fringe(std::span<const BorderEdge> borders, std::span<const TissuePiece> pieces, const WoundMap& map,
                        double height, const PartAt& part_at, const FullnessAt& fullness_at, Film& film) {
  const std::vector<double> bare(map.lip.size(), 2 * kNoCoat);
  FaceCoat coat{.height = height, .outside = bare, .inside = bare, .dry = std::vector<double>(bare.size(), 0)};
  for (std::uint32_t v = 0; v < bare.size(); ++v) {
    if (map.lip[v] != v) continue;
    const FringePart part = part_at(v);
    std::tie(coat.outside[v], coat.inside[v]) = fullness_at(v, part);
    coat.dry[v] = part.dry;
  }
  for (const TissuePiece& piece : pieces) {
    if (piece.side == TissueSide::kRim) append_faces(borders, piece, map, coat, film);
  }
}

/// Between lips that lie together a fringe stands as deep as beside them: what is pale there would show in single
/// pixels. `gapes`: what lip_gapes gives; `part_at`: FringePart of a lip's vertex.
template <typename PartAt>
void append_between_lips(std::span<const BorderEdge> borders, std::span<const TissuePiece> pieces, const WoundMap& map,
                         std::span<const double> gapes, const Fringe& fringe, const PartAt& part_at, Film& film) {
  const auto fullness_at = [&](std::uint32_t v, const FringePart& part) {
    const double fullness = std::lerp(2 * kNoCoat, part.spread - fringe.spare, std::exp(-gapes[v] / kBridged));
    return std::pair(fullness, fullness);
  };
  append_with_fringe(borders, pieces, map, fringe.height, part_at, fullness_at, film);
}

/// What comes over a lip has come up its face: below it a fringe goes on, the farther the more there is of it.
template <typename PartAt>
void append_below_lips(std::span<const BorderEdge> borders, std::span<const TissuePiece> pieces, const WoundMap& map,
                       const Fringe& fringe, const PartAt& part_at, Film& film) {
  constexpr double kFallsOff = 0.8;  // fullness, from the outer edge of a face to the inner one
  constexpr double kThinner = 0.4;   // than where it lies on the level
  const auto fullness_at = [&](std::uint32_t, const FringePart& part) {
    const double fullness = part.spread - fringe.spare;
    return std::pair(fullness, fullness - kFallsOff);
  };
  append_with_fringe(borders, pieces, map, kThinner * fringe.height, part_at, fullness_at, film);
}

/// On the ground of a wound. `bed`: its vertices are the wall's.
void append_ground(const TissuePiece& bed, const WoundLayout& wounds, const Shed& shed, Film& film) {
  const auto offset = static_cast<std::uint32_t>(film.vertices.size());
  for (std::uint32_t v = 0; v < bed.vertices.size(); ++v) {
    const std::uint32_t lip = wounds.map.lip[v];
    double fullness = 2 * kNoCoat, dry = 0;
    if (lip != WoundMap::kNoLip) {
      const double away = wounds.map.from_lip[v] / kMiddle, far = wounds.map.from_lip[v] / kGroundEnds;
      const double most = kGround + kGroundMiddle * std::exp(-away * away) + kNoCoat * std::pow(far, 4);
      fullness = shed.amount[lip] * (1 + most) - 1;
      dry = shed.dry[lip];
    }
    film.vertices.push_back(wound_coat(bed.vertices[v], fullness, kFaceHeight, dry));
  }
  for (std::size_t c = 0; c + 3 <= bed.corners.size(); c += 3) {
    const auto triangle = std::span(bed.corners).subspan(c, 3);
    const bool is_bloody = std::ranges::any_of(
        triangle, [&](std::uint32_t v) { return film.vertices[offset + v].inward > static_cast<float>(kNoCoat); });
    if (!is_bloody) continue;
    for (const std::uint32_t v : triangle) film.corners.push_back(offset + v);
  }
}

/// What of its blood comes to a run over level wall: none near the ends of a cut, also while that goes on.
double part_of_pool(const FluidRun& run, const WoundMap& map, double time) {
  constexpr double kGrows = 0.003;  // metres, farther off
  if (!run.creeps || !map.goes_on()) return 1;
  double off = std::numeric_limits<double>::infinity();
  const WallPlace& lip = run.path.front();
  for (std::size_t k = 0; k < 3; ++k) {
    if (lip.weights[k] > 0) off = std::min(off, map.off_end(lip.corners[k], time));
  }
  return std::clamp((off - kPoolsOffEnds) / kGrows, 0.0, 1.0);
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

Film blood_film(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                std::span<const TissuePiece> pieces, const WoundLayout& wounds, const Bleeding& bleeding, double time) {
  Film film;
  const std::vector<double> tapering = wounds.map.tapering(time);
  const Shed shed = shed_blood(*surface.topology, wounds, bleeding.strength, time);
  const std::vector<double> gapes = lip_gapes(surface, wounds.map);
  // What runs out of the body washes away what would run beside it.
  const double left = std::exp(-bleeding.leaked / kFirstDrops);
  const auto over_lip = [&](std::uint32_t lip) {
    const double most = 1 + 0.5 * wounds.fall[lip] + kPressedOut * std::exp(-gapes[lip] / kLipRoom);
    // Where a run begins it comes over the lip little by little, however far that gapes.
    constexpr double kGathering = 1;  // seconds
    const double foot = kBloodFoot * left * std::cbrt(bleeding.strength) * tapering[lip] * wounds.blood_feet[lip] *
                        (1 - std::exp(-age_of(*surface.topology, lip, time) / kGathering));
    return FringePart{.spread = shed.amount[lip] * std::sqrt(tapering[lip]) * most + foot, .dry = shed.dry[lip]};
  };
  append_fringe(pieces.front(), wounds, kBlood, over_lip, film);
  const FaceCoat on_faces = blood_on_faces(wounds, gapes, shed);
  for (const TissuePiece& piece : pieces) {
    if (piece.side == TissueSide::kRim) append_faces(borders, piece, wounds.map, on_faces, film);
    if (piece.side == TissueSide::kBed) append_ground(piece, wounds, shed, film);
  }
  append_below_lips(borders, pieces, wounds.map, kBlood, over_lip, film);
  const std::vector<Float3> normals = normals_of(pieces.front());
  for (const FluidRun& run : wounds.blood_runs) {
    const double age = time - run.born - 0.4 * run.chance;
    const double thickness = thickness_at(run, *surface.topology);
    const double lip = std::min(kBloodFrom, 0.5 * wounds.map.length);
    const double volume = part_of_pool(run, wounds.map, time) * left * bleeding.strength * (0.5 + run.chance) * lip *
                          thickness * blood_shed(age);
    const double way = static_cast<double>(run.path.size() - 1) * kRunStep;
    const BloodRun blood{.most_half_width = blood_half_width(run, thickness),
                         .volume = volume,
                         .age = age,
                         .way = way,
                         .creeps = run.creeps};
    append_run(surface, normals, run, blood_run(blood), film);
  }
  return film;
}

double share_of_run(const WoundLayout& wounds, double leaked) {
  return leaked / static_cast<double>(std::max<std::size_t>(1, wounds.fluid_runs.size()));
}

RunoffSection runoff_section(const FluidRun& run, const WoundLayout& wounds, double leaked) {
  constexpr double kHeight = 0.0006;                // metres
  constexpr double kLeast = 0.0003, kOfCut = 0.45;  // metres, and of the length of the cuts, which have two lips
  // A run is as steep at its sides however wide it is, so the flow goes with the fourth power of the width.
  constexpr double kUsual = 1e-6, kLeastSwollen = 0.5, kMostSwollen = 1.25;  // metres^3 of a run; of the usual width
  const double swollen = std::clamp(std::pow(share_of_run(wounds, leaked) / kUsual, 0.25), kLeastSwollen, kMostSwollen);
  const double opening = kLeast + kOfCut * 0.5 * wounds.map.length;
  return {.half_width = std::min(swollen * (0.0014 + 0.0012 * run.chance), std::max(1.0, swollen) * opening),
          .height = swollen * kHeight};
}

Film runoff_film(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                 std::span<const TissuePiece> pieces, const WoundLayout& wounds, double leaked, double time) {
  Film film;
  if (!(leaked > 0)) return film;
  const double welling = 1 - std::exp(-leaked / kFirstDrops);
  const std::vector<double> tapering = wounds.map.tapering(time);
  const auto part = [&](std::uint32_t lip) {
    // It leaves over the lower lip, and hardly wets the upper one.
    const double foot = kFluidFoot * wounds.fluid_feet[lip];
    const double spread = welling * (tapering[lip] * (1 + 0.6 * wounds.fall[lip]) + std::sqrt(tapering[lip]) * foot);
    return FringePart{.spread = spread, .dry = 0};
  };
  append_fringe(pieces.front(), wounds, kWelling, part, film);
  append_between_lips(borders, pieces, wounds.map, lip_gapes(surface, wounds.map), kWelling, part, film);
  const std::vector<Float3> normals = normals_of(pieces.front());
  for (const FluidRun& run : wounds.fluid_runs) {
    const auto [half_width, height] = runoff_section(run, wounds, leaked);
    append_run(
        surface, normals, run,
        {.half_width = half_width,
         .length = run_length(share_of_run(wounds, leaked), 2 * half_width, height, time - run.born, kRunoffSpeed),
         .height = height,
         .dry = 0,
         .swell = 0.5 * kRunoffSpeed * time},
        film);
  }
  return film;
}

Film bare_edge_film(const SnapshotSurface& surface, std::span<const BorderEdge> borders,
                    std::span<const TissuePiece> pieces, const WoundLayout& wounds, double time) {
  Film film;
  const std::vector<double> tapering = wounds.map.tapering(time);
  const std::vector<double> gapes = lip_gapes(surface, wounds.map);
  constexpr double kSoaking = 0.1, kSeeping = 0.03;  // seconds: what it soaks up comes little by little
  constexpr double kSeam = 1.2, kClosed = 0.0006;  // fullness that lips less than half of that apart, metres, have more
  const auto part = [&](std::uint32_t lip) {
    const double age = age_of(*surface.topology, lip, time);
    // Of closed lips it is all that is seen, up to the blade.
    const double seam = kSeam * std::min(1.0, 2 * std::exp(-gapes[lip] / kClosed)) * std::cbrt(tapering[lip]);
    const double spread = tapering[lip] * (1 - std::exp(-age / kSoaking)) + seam * (1 - std::exp(-age / kSeeping));
    return FringePart{.spread = spread, .dry = 0};
  };
  append_fringe(pieces.front(), wounds, kBareEdge, part, film);
  append_between_lips(borders, pieces, wounds.map, gapes, kBareEdge, part, film);
  return film;
}

}  // namespace thinwall
