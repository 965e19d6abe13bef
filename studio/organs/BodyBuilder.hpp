#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/body/BodyDefinition.hpp"
#include "studio/organs/SurfaceOrigin.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// The surface of a body, from a mesh file or a shape, metres. Adds to `notes` what was found and done.
/// Throws InputErrors at `location`: see import_mesh; an annulus whose inner radius is not below the outer.
SurfaceMesh make_surface(const std::variant<MeshFileSource, ShapeSource>& source, const SourceLocation& location,
                         std::vector<std::string>& notes);

/// Everything that the engine needs of a body: its surface made, the fields of its wall resolved to the triangles. Adds
/// to `notes`. Throws InputErrors: see make_surface; a fluid in a surface that is not closed; see WallFieldResolver;
/// regions of loads and fixed vertices that hold nothing.
BodyDefinition build_body(const BodyScenario& body, std::vector<std::string>& notes);

}  // namespace thinwall
