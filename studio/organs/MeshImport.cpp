#include "studio/organs/MeshImport.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "engine/contact/SelfIntersections.hpp"
#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "studio/organs/HoleFilling.hpp"
#include "studio/organs/ManifoldRepair.hpp"
#include "studio/organs/MeshFile.hpp"
#include "studio/organs/MeshRepair.hpp"
#include "studio/organs/NestedParts.hpp"
#include "studio/organs/OrganSizes.hpp"
#include "studio/organs/OwnEdges.hpp"
#include "studio/organs/StlHead.hpp"
#include "studio/organs/ToldPlaces.hpp"
#include "studio/organs/remeshing/MeshRemeshing.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// Of the extent. Single-precision coordinates, which most files hold, are good to 1e-7 of it.
constexpr double kWeldTolerance = 1e-6;

/// Of the area: what a surface has more than is the whole of it, and the rest is debris of a segmentation.
constexpr double kWholeShare = 0.99;

/// Most that `remesh` makes; a run would take hours with more.
constexpr int kMostTriangles = 200'000;

/// How far `remesh` may change the volume.
constexpr double kMostVolumeChange = 0.05;

/// Metres across to which a unit should lead that is named instead of a doubted one.
constexpr double kSmallOrgan = 5e-3, kLargeOrgan = 1;

/// A line that doubts the unit of a file whose surface is so far across, metres; empty where that may be.
std::string doubt_of_unit(double across, double unit) {
  if (across >= kTooSmall && across <= kTooLarge) return {};
  constexpr std::array<std::pair<double, const char*>, 3> kUnits = {{{1e-3, "mm"}, {1e-2, "cm"}, {1, "m"}}};
  std::string cure;
  for (const auto& [length, name] : kUnits) {
    const double instead = across / unit * length;
    if (!cure.empty() || instead < kSmallOrgan || instead > kLargeOrgan) continue;
    cure = fmt::format("; with `unit: {}` it is {:.3g} mm", name, 1e3 * instead);
  }
  return fmt::format("is {:.3g} m across, which no organ is: see whether `unit` is the file's{}", across, cure);
}

class MeshImport {
 public:
  MeshImport(const std::filesystem::path& file, const SurfaceOrigin& origin, const ImportOptions& options)
      : file_(file), origin_(origin), options_(options) {}

  ImportedMesh run() {
    RawMesh raw = read();
    tell_left_out();
    check_coordinates(raw);
    const std::optional<std::size_t> open = own_open_edges(file_, raw);
    part_names_ = std::move(raw.part_names);
    surface_ = {std::move(raw.vertices), std::move(raw.triangles), std::move(raw.parts)};
    tidy();
    if (open) tell_joined(*open);
    if (options_.repair) part_what_touches();
    drop_debris();
    orient();
    if (options_.repair) fill_holes();
    if (options_.edge_length > 0) remesh();
    ImportedMesh result;
    result.mesh = finish();
    tell_intersections();
    tell_nested_parts();
    describe(result.mesh);
    result.notes = std::move(notes_);
    return result;
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    throw InputErrors({{origin_.location, fmt::format("{}: {}: {}", origin_.key_path, origin_.name, reason)}});
  }

  RawMesh read() const {
    try {
      return read_mesh_file(file_);
    } catch (const MeshFileError& error) {
      refuse(error.what());
    }
  }

  void check_coordinates(const RawMesh& raw) const {
    const auto bad =
        std::find_if(raw.vertices.begin(), raw.vertices.end(), [](const Eigen::Vector3d& v) { return !v.allFinite(); });
    if (bad == raw.vertices.end()) return;
    refuse(fmt::format("the coordinates ({:g}, {:g}, {:g}) of a vertex are no finite numbers; mend or remove it",
                       (*bad)[0], (*bad)[1], (*bad)[2]));
  }

  void note_if(std::size_t count, const std::string& one, const std::string& many, const std::string& what) {
    if (count > 0) notes_.push_back(fmt::format("{}: {} {}", origin_.name, counted(count, one, many), what));
  }

  void tell_left_out() {
    const std::optional<StlHead> head = binary_stl_head(file_);
    if (!head) return;
    note_if(head->bytes_behind, "byte", "bytes",
            fmt::format("behind the {} that its head announces left out",
                        counted(head->announced, "triangle", "triangles")));
  }

  void tidy() {
    const double extent = extent_of(surface_);
    if (extent == 0) refuse("all its vertices are at one place");
    const double tolerance = kWeldTolerance * extent;
    note_if(remove_unused_vertices(surface_), "vertex", "vertices", "that no triangle uses removed");
    note_if(weld_vertices(surface_, tolerance), "vertex", "vertices",
            fmt::format("welded to others nearer than {:.3g} {}", tolerance, origin_.unit_name));
    note_if(remove_collapsed_triangles(surface_), "triangle", "triangles", "with a corner twice removed");
    note_if(remove_repeated_triangles(surface_), "triangle", "triangles", "with the corners of another removed");
    note_if(remove_flat_triangles(surface_, tolerance), "triangle", "triangles",
            fmt::format("lower than {:.3g} {} merged into neighbours or removed", tolerance, origin_.unit_name));
    if (surface_.triangles.empty()) refuse("all its triangles are flat or collapsed to a point: nothing is left");
  }

  /// `open`: edges of one face only, as the file counts its vertices.
  void tell_joined(std::size_t open) {
    const std::size_t now = topology().open_edges.size();
    note_if(open > now ? (open - now) / 2 : 0, "edge", "edges",
            fmt::format("joined whose two faces have corners of their own at the same places; a slit stays one where "
                        "its lips are farther apart than {:.3g} {}",
                        kWeldTolerance * extent_of(surface_), origin_.unit_name));
  }

  std::string places(const std::vector<Eigen::Vector3d>& points) const {
    return told_places(points, place_text, origin_.unit_name);
  }

  void part_what_touches() {
    const RemovedFlaps flaps = remove_flaps(surface_);
    note_if(flaps.places.size(), "flap", "flaps",
            fmt::format("with {} that hung on the surface removed: {}",
                        counted(flaps.triangles, "triangle", "triangles"), places(flaps.places)));
    const SplitPlaces split = split_apart(surface_);
    note_if(split.turned, "triangle", "triangles", "turned to agree with the others");
    note_if(split.edges.size(), "edge", "edges",
            "shared by more than two triangles split apart, middles at " + places(split.edges));
    note_if(split.vertices.size(), "vertex", "vertices",
            "in which parts touched split apart: " + places(split.vertices));
  }

  void fill_holes() {
    check_branches();
    const double tolerance = kWeldTolerance * extent_of(surface_);
    const std::vector<FoundHole> holes = fill_small_holes(surface_, tolerance);
    for (const bool filled : {true, false}) {
      std::vector<FoundHole> alike;
      std::copy_if(holes.begin(), holes.end(), std::back_inserter(alike),
                   [&](const FoundHole& hole) { return hole.filled == filled; });
      const auto describe = [&](const FoundHole& hole) {
        return fmt::format("{}, {:.3g} across, at {}", counted(hole.edges, "edge", "edges"), hole.width,
                           place_text(hole.middle));
      };
      note_if(alike.size(), "hole", "holes",
              (filled ? "filled: " : "left open: ") + told_places(alike, describe, origin_.unit_name));
    }
    // A crack is filled with flat triangles.
    note_if(remove_flat_triangles(surface_, tolerance), "flat triangle", "flat triangles",
            "of the filling merged into neighbours");
  }

  void check_branches() const {
    const MeshTopology now = topology();
    if (now.crowded_edges.empty()) return;
    std::vector<Eigen::Vector3d> middles;
    for (const int e : now.crowded_edges) {
      middles.push_back((surface_.vertices[now.edges[e][0]] + surface_.vertices[now.edges[e][1]]) / 2);
    }
    refuse(
        fmt::format("repair cannot tell inside from outside at {} shared by more than two triangles, with the "
                    "middles {}; the wall branches there; take the inner surfaces out of the mesh",
                    counted(middles.size(), "edge", "edges"), places(middles)));
  }

  void drop_debris() {
    const std::vector<SurfaceComponent> components = components_of(surface_);
    double whole = 0;
    int largest = 0;
    for (int c = 0; c < static_cast<int>(components.size()); ++c) {
      whole += components[c].area;
      if (components[c].area > components[largest].area) largest = c;
    }
    const std::size_t before = surface_.triangles.size();
    if (components.size() > 1 && components[largest].area > kWholeShare * whole) {
      keep_component(surface_, largest);
      notes_.push_back(fmt::format("{}: {} with {} removed, {:.2g} % of the area", origin_.name,
                                   counted(components.size() - 1, "separate part", "separate parts"),
                                   counted(before - surface_.triangles.size(), "triangle", "triangles"),
                                   100 * (1 - components[largest].area / whole)));
    } else if (components.size() > 1) {
      notes_.push_back(fmt::format("{}: {} separate parts", origin_.name, components.size()));
    }
    remove_unused_vertices(surface_);
  }

  void orient() {
    const OrientationResult result = orient_outwards(surface_);
    if (!result.orientable) {
      refuse("it has no inside and outside: like a Moebius band, its triangles cannot be turned to agree everywhere");
    }
    note_if(result.turned, "triangle", "triangles", "turned to agree with the others");
    note_if(result.turned_inside, "surface", "surfaces", "that faced inwards turned outwards");
  }

  double area() const {
    double sum = 0;
    for (const double part : triangle_areas(surface_.vertices, surface_.triangles)) sum += part;
    return sum;
  }

  double least_angle() const {
    const std::vector<double> angles = smallest_angles(surface_.vertices, surface_.triangles);
    return *std::min_element(angles.begin(), angles.end()) * 180 / std::numbers::pi;
  }

  MeshTopology topology() const { return topology_of(static_cast<int>(surface_.vertices.size()), surface_.triangles); }

  void remesh() {
    const double length = options_.edge_length / origin_.unit;  // units of the file
    if (!is_oriented_manifold(topology())) {
      refuse(fmt::format("`remesh` needs a surface whose parts nowhere touch or branch{}",
                         options_.repair ? "" : "; `repair: true` may mend that"));
    }
    const double wanted = area() / (std::sqrt(3.0) / 4 * length * length);
    if (wanted > kMostTriangles) {
      refuse(
          fmt::format("`remesh` with edges of {:.3g} mm would make about {:.2g} triangles, but {} are the most; ask "
                      "for longer edges",
                      1e3 * options_.edge_length, wanted, kMostTriangles));
    }
    const std::size_t count = surface_.triangles.size();
    const double angle = least_angle();
    const double volume = enclosed_volume(surface_.vertices, surface_.triangles);
    RemeshedMesh mesh = remesh_to_length({surface_.vertices, surface_.triangles}, length);
    check_remeshed(mesh, length);
    std::vector<int> parts;
    for (const int t : mesh.source) parts.push_back(surface_.parts[t]);
    surface_ = {std::move(mesh.surface.vertices), std::move(mesh.surface.triangles), std::move(parts)};
    const MeshTopology now = topology();
    std::string note = fmt::format(
        "{}: remeshed to edges of {:.3g} mm: {} to {} triangles, smallest angle {:.2g} to "
        "{:.2g} deg, at most {:.2g} mm from the given surface",
        origin_.name, 1e3 * options_.edge_length, count, surface_.triangles.size(), angle, least_angle(),
        1e3 * mesh.largest_distance * origin_.unit);
    if (is_closed(now)) {
      const double after = enclosed_volume(surface_.vertices, surface_.triangles);
      note += fmt::format(", volume {:+.2g} %", 100 * (after / volume - 1));
    }
    notes_.push_back(note);
  }

  void check_remeshed(const RemeshedMesh& mesh, double length) const {
    if (mesh.largest_distance > kMostMoved * length) {
      refuse(
          fmt::format("`remesh` with edges of {:.3g} mm is too coarse: the surface would move by up to {:.2g} mm, more "
                      "than half of that; ask for shorter edges",
                      1e3 * options_.edge_length, 1e3 * mesh.largest_distance * origin_.unit));
    }
    const double volume = enclosed_volume(surface_.vertices, surface_.triangles);
    const double change = enclosed_volume(mesh.surface.vertices, mesh.surface.triangles) / volume - 1;
    if (is_closed(topology()) && std::abs(change) > kMostVolumeChange) {
      refuse(
          fmt::format("`remesh` with edges of {:.3g} mm is too coarse: the volume would change by {:+.2g} %; ask for "
                      "shorter edges",
                      1e3 * options_.edge_length, 100 * change));
    }
    std::set<int> kept;
    for (const int t : mesh.source) kept.insert(surface_.parts[t]);
    for (const int part : surface_.parts) {
      if (kept.contains(part)) continue;
      refuse(fmt::format(
          "`remesh` with edges of {:.3g} mm is too coarse: no triangle of {} would be left; ask for shorter "
          "edges",
          1e3 * options_.edge_length, list_in_backticks(part_names_[part])));
    }
  }

  SurfaceMesh finish() const {
    SurfaceMesh mesh;
    mesh.triangles = surface_.triangles;
    for (const Eigen::Vector3d& v : surface_.vertices) mesh.vertices.push_back(v * origin_.unit);
    std::map<std::string, std::set<int>> groups;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      for (const std::string& name : part_names_[surface_.parts[t]]) {
        for (const int v : surface_.triangles[t]) groups[name].insert(v);
      }
    }
    for (const auto& [name, members] : groups) mesh.groups[name].assign(members.begin(), members.end());
    if (!mesh.groups.contains("wall")) {
      std::vector<int>& wall = mesh.groups["wall"];
      wall.resize(mesh.vertices.size());
      std::iota(wall.begin(), wall.end(), 0);
    }
    return mesh;
  }

  void describe(const SurfaceMesh& mesh) {
    Eigen::Vector3d low = mesh.vertices.front();
    Eigen::Vector3d high = low;
    for (const Eigen::Vector3d& v : mesh.vertices) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
    const Eigen::Vector3d size = (high - low) * 1e3;
    const MeshTopology topology = topology_of(static_cast<int>(mesh.vertices.size()), mesh.triangles);
    std::vector<std::string> names;
    for (const auto& [name, members] : mesh.groups) names.push_back(name);
    notes_.push_back(fmt::format(
        "{}: {} triangles, {} vertices, {}, {:.3g} x {:.3g} x {:.3g} mm, smallest angle {:.2g} deg, groups {}",
        origin_.name, mesh.triangles.size(), mesh.vertices.size(), is_closed(topology) ? "closed" : "open", size[0],
        size[1], size[2], quality_of(mesh).least_angle * 180 / std::numbers::pi, list_in_backticks(names)));
    const std::string doubt = doubt_of_unit((high - low).maxCoeff(), origin_.unit);
    if (!doubt.empty()) notes_.push_back(fmt::format("{} {}", origin_.name, doubt));
  }

  void tell_intersections() {
    Eigen::VectorXd position(3 * static_cast<Eigen::Index>(surface_.vertices.size()));
    for (std::size_t v = 0; v < surface_.vertices.size(); ++v) {
      position.segment<3>(3 * static_cast<Eigen::Index>(v)) = surface_.vertices[v];
    }
    std::vector<Eigen::Vector3d> middles;
    std::array<int, 2> last = {-1, -1};
    for (const SurfaceIntersection& one : self_intersections(surface_.triangles, position)) {
      if (one.edge != last) middles.push_back((surface_.vertices[one.edge[0]] + surface_.vertices[one.edge[1]]) / 2);
      last = one.edge;
    }
    note_if(
        middles.size(), "edge passes", "edges pass",
        fmt::format("through the surface, with the middles {}; the wall does not keep out of itself there, and what "
                    "it encloses twice counts twice: mend the mesh",
                    places(middles)));
  }

  void tell_nested_parts() {
    const std::vector<SurfaceComponent> components = components_of(surface_);
    std::vector<std::string> inner;
    for (const int part : nested_parts(surface_)) {
      inner.push_back(counted(components[part].triangles, "triangle", "triangles"));
    }
    note_if(inner.size(), "separate part lies", "separate parts lie",
            fmt::format("within another ({}); what surrounds a part does not press on it, and the room that it takes "
                        "counts as the outer part's too: a wall with an inner and an outer surface is one of them with "
                        "its `thickness`",
                        fmt::join(inner, ", ")));
  }

  const std::filesystem::path& file_;
  const SurfaceOrigin& origin_;
  const ImportOptions& options_;
  RawSurface surface_;
  std::vector<std::vector<std::string>> part_names_;
  std::vector<std::string> notes_;
};

}  // namespace

SurfaceOrigin mesh_origin(const std::filesystem::path& file, double metres_per_unit, const std::string& key_path,
                          const SourceLocation& location) {
  return {.name = "mesh `" + file.generic_string() + "`",
          .unit = metres_per_unit,
          .unit_name = "units of the file",
          .key_path = key_path,
          .location = location};
}

ImportedMesh import_mesh(const std::filesystem::path& file, const SurfaceOrigin& origin, const ImportOptions& options) {
  return MeshImport(file, origin, options).run();
}

}  // namespace thinwall
