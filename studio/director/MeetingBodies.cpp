#include "studio/director/MeetingBodies.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "studio/director/BodyExtent.hpp"

namespace thinwall {
namespace {

bool is_scenery(const Body& body) {
  return is_scenery(body.model().definition.fixed);
}

}  // namespace

std::vector<std::string> MeetingBodies::notes(std::span<const std::unique_ptr<Body>> bodies, double time) {
  std::vector<std::string> notes;
  if (bodies.size() < 2) return notes;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const auto& body : bodies) boxes.push_back(box_of(body->surface()));
  for (std::size_t first = 0; first < bodies.size(); ++first) {
    for (std::size_t second = first + 1; second < bodies.size(); ++second) {
      if (!boxes[first].intersects(boxes[second]) || !told_.emplace(first, second).second) continue;
      if (time == 0 && (is_scenery(*bodies[first]) || is_scenery(*bodies[second]))) continue;
      notes.push_back(
          fmt::format("bodies `{}` and `{}` come so near from {:.4g} s on that they may meet (the upright boxes around "
                      "them overlap): "
                      "they do not feel each other, and one passes through the other; only tools press on walls",
                      bodies[first]->model().definition.name, bodies[second]->model().definition.name, time));
    }
  }
  return notes;
}

}  // namespace thinwall
