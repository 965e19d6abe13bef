#include "studio/organs/BodyBuilder.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "engine/equilibrium/Chambers.hpp"
#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/Shapes.hpp"
#include "studio/organs/ClosedCheck.hpp"
#include "studio/organs/HoleFilling.hpp"
#include "studio/organs/MeshImport.hpp"
#include "studio/organs/OrganSizes.hpp"
#include "studio/organs/RegionMembers.hpp"
#include "studio/organs/WallFieldResolver.hpp"
#include "studio/schema/Wording.hpp"

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
     [](const ShapeSource& s) {
       return s.slit ? make_slit_annulus(s.inner_radius, s.radius, s.triangles)
                     : make_annulus(s.inner_radius, s.radius, s.triangles);
     }},
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

/// As it lies about its own origin.
SurfaceMesh make_unplaced(const SurfaceSource& source, const SurfaceOrigin& origin, std::vector<std::string>& notes) {
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
  const Eigen::Vector3d size = bounding_box(mesh.vertices).sizes();
  notes.push_back(fmt::format("{}: {} triangles ({} wanted), {} vertices, {:.3g} x {:.3g} x {:.3g} mm", origin.name,
                              mesh.triangles.size(), shape.triangles, mesh.vertices.size(), 1e3 * size.x(),
                              1e3 * size.y(), 1e3 * size.z()));
  if (const double across = size.maxCoeff(); across < kTooSmall || across > kTooLarge) {
    notes.push_back(
        fmt::format("{} is {:.3g} m across, which no organ is: see whether the units of its sizes are meant so",
                    origin.name, across));
  }
  return mesh;
}

SurfaceMesh make_surface(const SurfaceSource& source, const SurfaceOrigin& origin, std::vector<std::string>& notes) {
  SurfaceMesh mesh = make_unplaced(source, origin, notes);
  const auto& placed = std::visit(
      [](const auto& one) -> const auto& { return one.placed; }, source);
  if (!placed) return mesh;
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = placed->place_of(vertex);
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

/// That each chamber's point names a closed part of its own.
void check_chambers(const BodyScenario& body, const SurfaceMesh& mesh) {
  std::vector<Eigen::Vector3i> surface = mesh.triangles;
  surface.insert(surface.end(), mesh.cap_triangles.begin(), mesh.cap_triangles.end());
  FluidDefinition fluid = body.fluid;
  fluid.chambers.clear();
  for (const ChamberDefinition& chamber : body.fluid.chambers) {
    const std::size_t k = fluid.chambers.size();
    fluid.chambers.push_back(chamber);
    try {
      find_chambers(mesh.vertices, surface, fluid);
    } catch (const std::invalid_argument& refusal) {
      const SourceLocation& location = k < body.chamber_locations.size() ? body.chamber_locations[k] : body.location;
      throw InputErrors(
          {{location, fmt::format("bodies.{}.contents.chambers.{}.at: {}; move it into the part that is meant",
                                  body.name, chamber.name, refusal.what())}});
    }
  }
}

/// A wall thicker than the organ is one of a wrong unit; twice that leaves room for patches of a few triangles.
void check_thickness(const BodyScenario& body, const BodyDefinition& definition) {
  const double thickest = *std::ranges::max_element(definition.thickness);
  const double extent = bounding_box(definition.mesh.vertices).sizes().maxCoeff();
  if (thickest <= 2 * extent) return;
  const std::string message = fmt::format(
      "bodies.{}.wall.thickness: {:.4g} mm is more than twice the surface's extent, {:.4g} mm; set the unit of "
      "either right",
      body.name, 1e3 * thickest, 1e3 * extent);
  throw InputErrors({{body.thickness.location, message}});
}

void check_fixed(const BodyScenario& body, RegionMembers& regions) {
  for (std::size_t i = 0; i < body.fixed.size(); ++i) {
    const std::string path = fmt::format("bodies.{}.fixed[{}].region", body.name, i + 1);
    const bool has_location = i < body.fixed_locations.size();
    regions.vertices(body.fixed[i].region, path, has_location ? body.fixed_locations[i] : body.location);
  }
}

void check_loads(const BodyScenario& body, RegionMembers& regions) {
  for (std::size_t i = 0; i < body.loads.size(); ++i) {
    const std::string path = fmt::format("bodies.{}.loads[{}].region", body.name, i + 1);
    const LoadScenario& load = body.loads[i];
    const bool on_surface = load.load.kind == LoadKind::kFollowerPressure ||
                            load.load.kind == LoadKind::kDeadTraction || load.load.kind == LoadKind::kDeadBodyForce;
    if (on_surface) {
      regions.triangles(load.load.region, path, load.location);
    } else if (load.load.kind == LoadKind::kDeadLineForce || load.load.kind == LoadKind::kDeadMoment) {
      regions.edges(load.load.region, path, load.location);
    } else {
      regions.vertices(load.load.region, path, load.location);
    }
  }
}

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
                            .tension_field = body.tension_field,
                            .viscosity = body.viscosity,
                            .damping = body.damping,
                            .fluid = body.fluid,
                            .fixed = body.fixed};
  if (body.fluid.kind != FluidKind::kNone) {
    check_closed(definition.mesh, body.surface, origin, std::max(1, static_cast<int>(body.fluid.chambers.size())));
    check_chambers(body, definition.mesh);
  }
  RegionMembers regions(definition.mesh);
  WallFieldResolver fields(body, regions, notes);
  definition.thickness = fields.thickness();
  definition.toughness = fields.toughness();
  check_thickness(body, definition);
  definition.materials = fields.materials();
  definition.fibres = fields.fibres();
  definition.prestretch = fields.prestretch();
  check_fixed(body, regions);
  check_loads(body, regions);
  for (const LoadScenario& load : body.loads) definition.loads.push_back(load.load);
  if (!regions.errors().empty()) throw InputErrors(std::move(regions.errors()));
  return definition;
}

}  // namespace thinwall
