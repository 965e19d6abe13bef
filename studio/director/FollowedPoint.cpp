#include "studio/director/FollowedPoint.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "engine/cutting/CarriedPoints.hpp"

namespace thinwall {

PointRecord FollowedPoint::record() const {
  const BodyDefinition& definition = body->model().definition;
  const Eigen::VectorXd& position = body->state().equilibrium.position;
  const Eigen::Vector3i& corners = definition.mesh.triangles[static_cast<std::size_t>(place.triangle)];
  PointRecord record{.body = definition.name, .point = name};
  for (int k = 0; k < 3; ++k) {
    record.position += place.weights[k] * position.segment<3>(3 * corners[k]);
    record.stress_free += place.weights[k] * definition.mesh.vertices[static_cast<std::size_t>(corners[k])];
  }
  return record;
}

FollowedPoint follow(const RecordedPoint& point, const std::vector<std::unique_ptr<Body>>& bodies) {
  const auto body =
      std::ranges::find(bodies, point.body, [](const auto& each) { return each->model().definition.name; });
  assert(body != bodies.end());
  const SurfaceMesh& mesh = (*body)->model().definition.mesh;
  FollowedPoint followed{.name = point.name, .body = body->get(), .place = {}};
  double nearest = std::numeric_limits<double>::infinity();
  int first = 0;  // vertex
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      const int vertex = mesh.triangles[t][corner];
      const double distance = (mesh.vertices[static_cast<std::size_t>(vertex)] - point.at).squaredNorm();
      if (distance > nearest || (distance == nearest && vertex >= first)) continue;
      nearest = distance;
      first = vertex;
      followed.place = {.triangle = static_cast<int>(t), .weights = Eigen::Vector3d::Unit(corner)};
    }
  }
  return followed;
}

void carry_over(std::vector<FollowedPoint>& points, const Body& body, const SurfaceMesh& before, const Cut& cut) {
  for (FollowedPoint& point : points) {
    if (point.body != &body) continue;
    const std::vector<SurfacePoint> places = {point.place};
    point.place = carried_over(places, before, body.model().definition.mesh, cut).front();
  }
}

}  // namespace thinwall
