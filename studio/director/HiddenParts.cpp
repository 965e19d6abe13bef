#include "studio/director/HiddenParts.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "studio/director/BodyExtent.hpp"
#include "studio/director/StressFreeSurface.hpp"

namespace thinwall {
namespace {

using Eigen::Vector3d;

/// Of a tool, metres above the wall, at least.
constexpr double kLeastAbove = 1e-3;

/// How far a camera stands that sees the whole of the bodies, in diagonals of their box.
constexpr double kDistance = 2;

struct Approach {
  std::string tool, body;
  Vector3d at, direction;
};

std::optional<Approach> approach_of(const Clip& clip) {
  const auto approach = [](const auto& action) {
    return Approach{action.tool, action.body, action.at, action.direction.normalized()};
  };
  if (const auto* palpate = std::get_if<PalpateClip>(&clip.action)) return approach(*palpate);
  if (const auto* pierce = std::get_if<PierceClip>(&clip.action)) return approach(*pierce);
  if (const auto* grasp = std::get_if<GraspClip>(&clip.action)) return approach(*grasp);
  return std::nullopt;
}

/// Where tools are as they come upon walls: a little above them.
std::vector<Vector3d> places_above_walls(const Scenario& scenario,
                                         const std::map<std::string, StressFreeSurface>& surfaces) {
  std::vector<Vector3d> places;
  for (const Clip& clip : scenario.timeline) {
    const std::optional<Approach> approach = approach_of(clip);
    if (!approach || !surfaces.contains(approach->body)) continue;
    const auto hit = first_entry(surfaces.at(approach->body).view(), approach->at, approach->direction);
    const auto tool = std::ranges::find(scenario.tools, approach->tool, &ToolDefinition::name);
    if (!hit || tool == scenario.tools.end()) continue;
    const double above = std::max(tool->radius, kLeastAbove);
    places.push_back(approach->at + (hit->travel - above) * approach->direction);
  }
  return places;
}

}  // namespace

std::vector<double> hidden_parts(const Scenario& scenario, std::span<const Vector3d> facings) {
  std::vector<double> parts(facings.size(), 0);
  std::map<std::string, StressFreeSurface> surfaces;
  Eigen::AlignedBox3d box;
  for (const BodyScenario& body : scenario.bodies) {
    if (is_scenery(body.fixed)) continue;
    std::optional<StressFreeSurface> surface = stress_free_surface(body);
    if (!surface) return parts;
    box.extend(box_of(surface->view()));
    surfaces.emplace(body.name, *std::move(surface));
  }
  const std::vector<Vector3d> places = places_above_walls(scenario, surfaces);
  if (places.empty()) return parts;
  for (std::size_t k = 0; k < facings.size(); ++k) {
    const Vector3d eye = box.center() - kDistance * box.diagonal().norm() * facings[k];
    const auto is_hidden = [&](const Vector3d& place) {
      return std::ranges::any_of(surfaces, [&](const auto& named) {
        return first_entry_on_segment(named.second.view(), eye, place).has_value();
      });
    };
    parts[k] = static_cast<double>(std::ranges::count_if(places, is_hidden)) / static_cast<double>(places.size());
  }
  return parts;
}

}  // namespace thinwall
