#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/mesh/SurfaceMesh.hpp"
#include "engine/tool/FirstContact.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// A body's surface before anything has happened to it.
struct StressFreeSurface {
  SurfaceMesh mesh;
  Eigen::VectorXd position;  // (3 vertices), metres
  bool open = false;         // encloses nothing

  SurfaceView view() const { return {mesh.triangles, position, open}; }
};

/// As a mesh file has it where a body's would be remeshed, which takes longer and changes it little. Nothing where it
/// cannot be made.
std::optional<StressFreeSurface> stress_free_surface(const BodyScenario& body);

}  // namespace thinwall
