#include "studio/haptics/CoarseScenario.hpp"

#include <algorithm>
#include <variant>

namespace thinwall {
namespace {

/// Multiple of the triangles of a coarse wall from which on a wall has far more.
constexpr double kFarMore = 1.4;

/// Triangles below which a tip of a quarter of an organ's radius lies on a handful of places.
constexpr int kFewestTriangles = 900;

}  // namespace

std::optional<Scenario> coarse_scenario(const Scenario& scenario, int triangles) {
  Scenario coarse = scenario;
  bool is_coarser = false;
  for (BodyScenario& body : coarse.bodies) {
    auto* shape = std::get_if<ShapeSource>(&body.surface);
    if (shape == nullptr) return {};
    if (shape->triangles <= kFarMore * triangles) continue;
    shape->triangles = triangles;
    is_coarser = true;
  }
  return is_coarser ? std::optional(coarse) : std::nullopt;
}

int affordable_triangles(int triangles, double duration, double limit) {
  if (duration <= limit) return triangles;
  // A solution of so small a wall takes nearly as its triangles do.
  const auto affordable = static_cast<int>(triangles * (limit / duration));
  return std::min(triangles, std::max(kFewestTriangles, affordable));
}

}  // namespace thinwall
