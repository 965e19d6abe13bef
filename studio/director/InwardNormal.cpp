#include "studio/director/InwardNormal.hpp"

#include <optional>

#include "engine/cutting/SurfacePath.hpp"
#include "studio/director/StressFreeSurface.hpp"

namespace thinwall {
namespace {

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
  const std::optional<StressFreeSurface> surface = stress_free_surface(body);
  if (!surface) return Eigen::Vector3d::Zero();
  return mean_inward(surface_path(surface->view(), clip.path, clip.direction, clip.reach).path);
}

}  // namespace thinwall
