#include "studio/organs/BodyBuilder.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/mesh/Shapes.hpp"
#include "studio/organs/ClosedCheck.hpp"
#include "studio/organs/HoleFilling.hpp"
#include "studio/organs/MeshImport.hpp"
#include "studio/scenario/Wording.hpp"

namespace thinwall {
namespace {

struct ShapeEntry {
  Shape shape;
  const char* name;
  SurfaceMesh (*make)(const ShapeSource&);
};

/// A new shape is a function of engine/mesh/Shapes.hpp and a row here.
const std::array<ShapeEntry, 8> kShapes = {{
    {Shape::kSphere, "sphere", [](const ShapeSource& s) { return make_sphere(s.radius, s.triangles); }},
    {Shape::kHemisphere, "hemisphere", [](const ShapeSource& s) { return make_hemisphere(s.radius, s.triangles); }},
    {Shape::kSemicylinder, "semicylinder",
     [](const ShapeSource& s) { return make_semicylinder(s.radius, s.length, s.triangles); }},
    {Shape::kSheet, "sheet", [](const ShapeSource& s) { return make_sheet(s.width, s.length, s.triangles); }},
    {Shape::kDisc, "disc", [](const ShapeSource& s) { return make_disc(s.radius, s.triangles); }},
    {Shape::kCylinder, "cylinder", [](const ShapeSource& s) { return make_cylinder(s.radius, s.length, s.triangles); }},
    {Shape::kAnnulus, "annulus",
     [](const ShapeSource& s) { return make_annulus(s.inner_radius, s.radius, s.triangles); }},
    {Shape::kStrip, "strip", [](const ShapeSource& s) { return make_sheet(s.width, s.length, s.triangles); }},
}};

const ShapeEntry& entry_of(Shape shape) {
  return *std::find_if(kShapes.begin(), kShapes.end(), [&](const ShapeEntry& entry) { return entry.shape == shape; });
}

using SurfaceSource = std::variant<MeshFileSource, ShapeSource>;

SurfaceOrigin origin_of(const SurfaceSource& source, const std::string& key_path, const SourceLocation& location) {
  if (const auto* file = std::get_if<MeshFileSource>(&source)) {
    return mesh_origin(file->file, file->unit, key_path, location);
  }
  return {.name = "shape " + in_backticks(entry_of(std::get<ShapeSource>(source).shape).name),
          .unit = 1e-3,
          .unit_name = "mm",
          .key_path = key_path,
          .location = location};
}

SurfaceMesh make_surface(const SurfaceSource& source, const SurfaceOrigin& origin, std::vector<std::string>& notes) {
  if (const auto* file = std::get_if<MeshFileSource>(&source)) {
    ImportedMesh imported = import_mesh(file->file, origin, {.repair = file->repair, .edge_length = file->edge_length});
    notes.insert(notes.end(), imported.notes.begin(), imported.notes.end());
    return std::move(imported.mesh);
  }
  const ShapeSource& shape = std::get<ShapeSource>(source);
  if (shape.shape == Shape::kAnnulus && !(shape.inner_radius < shape.radius)) {
    throw InputErrors({{origin.location, fmt::format("{}: inner_radius is {:.6g} mm, but must be below the radius of "
                                                     "{:.6g} mm",
                                                     origin.key_path, 1e3 * shape.inner_radius, 1e3 * shape.radius)}});
  }
  SurfaceMesh mesh = entry_of(shape.shape).make(shape);
  notes.push_back(fmt::format("{}: {} triangles ({} wanted), {} vertices", origin.name, mesh.triangles.size(),
                              shape.triangles, mesh.vertices.size()));
  return mesh;
}

/// Whether `repair: true` would make a closed surface of a mesh file.
bool repair_would_close(const MeshFileSource& file, const SurfaceOrigin& origin) {
  try {
    check_closed_for_fluid(import_mesh(file.file, origin, {.repair = true}).mesh, origin);
    return true;
  } catch (const InputErrors&) {
    return false;
  }
}

void check_closed(const SurfaceMesh& mesh, const SurfaceSource& source, const SurfaceOrigin& origin, int parts) {
  const auto* file = std::get_if<MeshFileSource>(&source);
  if (file != nullptr && file->repair) {
    check_closed_for_fluid(mesh, origin,
                           fmt::format("close the surface (`repair: true` fills holes of up to {} edges, up to {:.0f} "
                                       "% of the surface's extent across)",
                                       kMostHoleEdges, 100 * kWidestHole),
                           parts);
    return;
  }
  try {
    check_closed_for_fluid(mesh, origin, "close the surface", parts);
  } catch (const InputErrors& errors) {
    if (file == nullptr || !repair_would_close(*file, origin)) throw;
    std::vector<Diagnostic> advised = errors.diagnostics();
    for (Diagnostic& diagnostic : advised) diagnostic.message += "; `repair: true` would mend it";
    throw InputErrors(std::move(advised));
  }
}

std::string group_names(const SurfaceMesh& mesh) {
  std::vector<std::string> names;
  for (const auto& [name, members] : mesh.groups) names.push_back(name);
  return list_in_backticks(names);
}

/// "x -20 ... 20, y -20 ... 20, z 0 ... 20 mm"
std::string bounds_of(const SurfaceMesh& mesh) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                            [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a[axis] < b[axis]; });
    text += fmt::format("{}{} {:.4g} ... {:.4g}", axis == 0 ? "" : ", ", "xyz"[axis], 1e3 * (*low)[axis] + 0.0,
                        1e3 * (*high)[axis] + 0.0);
  }
  return text + " mm";
}

/// Collects the mistakes in a body's regions.
class RegionResolver {
 public:
  RegionResolver(const BodyScenario& body, const SurfaceMesh& mesh) : body_(body), mesh_(mesh) {}

  std::vector<double> thickness() {
    std::vector<double> values(mesh_.triangles.size(), body_.thickness.standard);
    for (std::size_t i = 0; i < body_.thickness.regions.size(); ++i) {
      const ThicknessRegion& region = body_.thickness.regions[i];
      const std::string path = fmt::format("bodies.{}.wall.thickness.regions[{}].in", body_.name, i);
      for (const int t :
           members(region.region, triangles_in, "wall triangle", path, at(body_.thickness_locations, i))) {
        values[t] = region.value;
      }
    }
    return values;
  }

  /// One direction for each triangle where they differ, one for all where they do not, none without fibres.
  std::vector<Eigen::Vector3d> fibres() {
    if (!body_.fibres) return {};
    std::vector<Eigen::Vector3d> directions(mesh_.triangles.size(), body_.fibres->along);
    std::vector<SourceLocation> locations(mesh_.triangles.size(), body_.fibres->location);
    const std::string path = fmt::format("bodies.{}.wall.fibres", body_.name);
    for (std::size_t i = 0; i < body_.fibres->regions.size(); ++i) {
      const FibreRegion& region = body_.fibres->regions[i];
      const std::string inner = fmt::format("{}.regions[{}].in", path, i + 1);
      for (const int t : members(region.region, triangles_in, "wall triangle", inner, region.location)) {
        directions[t] = region.along;
        locations[t] = region.location;
      }
    }
    for (std::size_t t = 0; t < directions.size(); ++t) {
      if (lies_in_plane(directions[t], t)) continue;
      const Eigen::Vector3d at = 1e3 * centroid(t);
      errors_.push_back({locations[t], fmt::format("{}: the fibres stand perpendicular to the wall at [{:.4g}, {:.4g}, "
                                                   "{:.4g}] mm; give the wall there a direction of its own with "
                                                   "`regions`",
                                                   path, at.x() + 0.0, at.y() + 0.0, at.z() + 0.0)});
      break;
    }
    return body_.fibres->regions.empty() ? std::vector{body_.fibres->along} : directions;
  }

  void check_fixed() {
    for (std::size_t i = 0; i < body_.fixed.size(); ++i) {
      const std::string path = fmt::format("bodies.{}.fixed[{}].region", body_.name, i);
      members(body_.fixed[i].region, vertices_in, "vertex", path, at(body_.fixed_locations, i));
    }
  }

  void check_loads() {
    for (std::size_t i = 0; i < body_.loads.size(); ++i) {
      const std::string path = fmt::format("bodies.{}.loads[{}].region", body_.name, i + 1);
      const LoadScenario& load = body_.loads[i];
      const bool on_surface = load.load.kind == LoadKind::kFollowerPressure ||
                              load.load.kind == LoadKind::kDeadTraction || load.load.kind == LoadKind::kDeadBodyForce;
      if (on_surface) {
        members(load.load.region, triangles_in, "wall triangle", path, load.location);
      } else {
        members(load.load.region, vertices_in, "vertex", path, load.location);
      }
    }
  }

  void throw_errors() {
    if (!errors_.empty()) throw InputErrors(std::move(errors_));
  }

 private:
  const SourceLocation& at(const std::vector<SourceLocation>& locations, std::size_t i) const {
    return i < locations.size() ? locations[i] : body_.location;
  }

  Eigen::Vector3d corner(std::size_t triangle, int k) const {
    return mesh_.vertices[static_cast<std::size_t>(mesh_.triangles[triangle][k])];
  }

  Eigen::Vector3d centroid(std::size_t triangle) const {
    return (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2)) / 3;
  }

  /// Whether a direction has a part in the plane of a triangle that means something: a thousandth of it.
  bool lies_in_plane(const Eigen::Vector3d& direction, std::size_t triangle) const {
    const Eigen::Vector3d first = corner(triangle, 1) - corner(triangle, 0);
    const Eigen::Vector3d normal = first.cross(corner(triangle, 2) - corner(triangle, 0)).normalized();
    return direction.cross(normal).norm() > 1e-3 * direction.norm();
  }

  template <typename Find>
  std::vector<int> members(const Region& region, const Find& find, const char* what, const std::string& path,
                           const SourceLocation& location) {
    const auto* group = std::get_if<GroupRegion>(&region);
    if (group != nullptr && !mesh_.groups.contains(group->name)) {
      std::vector<std::string> names;
      for (const auto& [name, vertices] : mesh_.groups) names.push_back(name);
      errors_.push_back(
          {location, fmt::format("{}: the surface has no group {}{}; it has {}", path, in_backticks(group->name),
                                 did_you_mean(group->name, names), group_names(mesh_))});
      return {};
    }
    std::vector<int> found = find(region, mesh_);
    if (found.empty() && std::holds_alternative<BoundaryRegion>(region)) {
      errors_.push_back({location, fmt::format("{}: holds no {}: the wall has no open edges", path, what)});
    } else if (found.empty()) {
      errors_.push_back(
          {location, fmt::format("{}: holds no {} of the surface, which spans {}", path, what, bounds_of(mesh_))});
    }
    return found;
  }

  const BodyScenario& body_;
  const SurfaceMesh& mesh_;
  std::vector<Diagnostic> errors_;
};

}  // namespace

SurfaceMesh make_surface(const SurfaceSource& source, const SourceLocation& location, std::vector<std::string>& notes) {
  return make_surface(source, origin_of(source, "surface", location), notes);
}

BodyDefinition build_body(const BodyScenario& body, std::vector<std::string>& notes) {
  const SurfaceOrigin origin =
      origin_of(body.surface, fmt::format("bodies.{}.surface", body.name), body.surface_location);
  BodyDefinition definition{.name = body.name,
                            .mesh = make_surface(body.surface, origin, notes),
                            .model = body.model,
                            .thickness = {},
                            .density = body.density,
                            .materials = {body.material},
                            .tension_field = body.tension_field,
                            .prestretch = {{.first = body.prestretch, .second = body.prestretch}},
                            .viscosity = body.viscosity,
                            .damping = body.damping,
                            .fluid = body.fluid,
                            .fixed = body.fixed};
  if (body.fluid.kind != FluidKind::kNone) {
    check_closed(definition.mesh, body.surface, origin, std::max(1, static_cast<int>(body.fluid.chambers.size())));
  }
  RegionResolver regions(body, definition.mesh);
  definition.thickness = regions.thickness();
  definition.fibres = regions.fibres();
  regions.check_fixed();
  regions.check_loads();
  for (const LoadScenario& load : body.loads) definition.loads.push_back(load.load);
  regions.throw_errors();
  return definition;
}

}  // namespace thinwall
