#include "studio/haptics/CoarseScenario.hpp"

#include <variant>

namespace thinwall {
namespace {

/// Multiple of the triangles of a coarse wall from which on a wall has far more.
constexpr double kFarMore = 1.4;

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

}  // namespace thinwall
