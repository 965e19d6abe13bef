#include "studio/director/FollowedPoint.hpp"

#include <algorithm>
#include <cassert>

namespace thinwall {

PointRecord FollowedPoint::record() const {
  const BodyDefinition& definition = body->model().definition;
  return {.body = definition.name,
          .point = name,
          .position = body->state().equilibrium.position.segment<3>(3 * vertex),
          .stress_free = definition.mesh.vertices[static_cast<std::size_t>(vertex)]};
}

FollowedPoint follow(const RecordedPoint& point, const std::vector<std::unique_ptr<Body>>& bodies) {
  const auto body =
      std::ranges::find(bodies, point.body, [](const auto& each) { return each->model().definition.name; });
  assert(body != bodies.end());
  const std::vector<Eigen::Vector3d>& vertices = (*body)->model().definition.mesh.vertices;
  const auto nearest = std::ranges::min_element(
      vertices, {}, [&](const Eigen::Vector3d& vertex) { return (vertex - point.at).squaredNorm(); });
  return {point.name, body->get(), static_cast<int>(nearest - vertices.begin())};
}

}  // namespace thinwall
