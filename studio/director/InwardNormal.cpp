#include "studio/director/InwardNormal.hpp"

#include <string>
#include <variant>
#include <vector>

#include "engine/cutting/SurfacePath.hpp"
#include "studio/organs/BodyBuilder.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

/// As a mesh file has it where it would be remeshed, which takes longer and changes normals little.
std::variant<MeshFileSource, ShapeSource> quick_source(const BodyScenario& body) {
  auto source = body.surface;
  if (auto* file = std::get_if<MeshFileSource>(&source)) file->edge_length = 0;
  return source;
}

Eigen::Vector3d mean_inward(const SurfacePath& path) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 1; k < path.stations.size(); ++k) {
    const double length = path.lengths[k] - path.lengths[k - 1];
    sum += 0.5 * length * (path.stations[k - 1].inward + path.stations[k].inward);
  }
  return sum.norm() > 0 ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d::Zero();
}

}  // namespace

Eigen::Vector3d inward_normal(const BodyScenario& body, const InciseClip& clip) {
  try {
    std::vector<std::string> untold;
    const SurfaceMesh mesh = make_surface(quick_source(body), body.location, untold);
    const Eigen::VectorXd position = Eigen::Map<const Eigen::VectorXd>(
        mesh.vertices.front().data(), 3 * static_cast<Eigen::Index>(mesh.vertices.size()));
    const SurfaceView surface{mesh.triangles, position, body.fluid.kind == FluidKind::kNone};
    return mean_inward(surface_path(surface, clip.path, clip.direction, clip.reach).path);
  } catch (const InputErrors&) {
    return Eigen::Vector3d::Zero();
  }
}

}  // namespace thinwall
