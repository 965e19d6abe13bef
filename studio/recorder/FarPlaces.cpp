#include "studio/recorder/FarPlaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/annotation/MaterialPoint.hpp"

namespace thinwall {
namespace {

double distance(const Double3& a, const Double3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A wall at rest.
class RestingWall {
 public:
  explicit RestingWall(const SnapshotSurface& surface) : surface_(surface) {
    surface_.positions = surface_.topology->rest_positions;
  }

  /// Metres; none where there is no wall.
  std::optional<double> distance_to(const Double3& place) const {
    const std::optional<MaterialPoint> point = nearest_material_point(*surface_.topology, place);
    if (!point) return std::nullopt;
    const Vector3 nearest = place_of(*point, surface_);
    return distance(place, {nearest.x, nearest.y, nearest.z});
  }

  /// The diagonal of its upright box, metres.
  double extent() const {
    Double3 low = {1e300, 1e300, 1e300}, high = {-1e300, -1e300, -1e300};
    for (const Float3& position : surface_.positions) {
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], static_cast<double>(position[i]));
        high[i] = std::max(high[i], static_cast<double>(position[i]));
      }
    }
    return distance(low, high);
  }

 private:
  SnapshotSurface surface_;
};

std::optional<RestingWall> wall_of(const Snapshot& snapshot, const std::string& body) {
  const auto found = std::ranges::find(snapshot.surfaces, body, &SnapshotSurface::body);
  return found == snapshot.surfaces.end() ? std::nullopt : std::optional<RestingWall>(*found);
}

class FarPlaces {
 public:
  explicit FarPlaces(const Snapshot& snapshot) : snapshot_(snapshot) {}

  /// A place for which the nearest one of the wall is taken.
  void see_point(const std::string& path, const std::string& body, const Double3& place) {
    constexpr double kFar = 0.5;  // of the wall's extent
    const std::optional<RestingWall> wall = wall_of(snapshot_, body);
    const std::optional<double> off = wall ? wall->distance_to(place) : std::nullopt;
    if (!off || *off <= kFar * wall->extent()) return;
    tell(path, *off, body, "the nearest place of its wall is taken");
  }

  void see_ball(const std::string& path, const std::string& body, const Double3& center, double radius) {
    const std::optional<RestingWall> wall = wall_of(snapshot_, body);
    const std::optional<double> off = wall ? wall->distance_to(center) : std::nullopt;
    if (off && *off > radius) tell(path, *off, body, fmt::format("the ball of {:.4g} mm meets no wall", 1e3 * radius));
  }

  std::vector<std::string> notes() && { return std::move(notes_); }

 private:
  void tell(const std::string& path, double off, const std::string& body, const std::string& consequence) {
    notes_.push_back(
        fmt::format("{}: it lies {:.4g} mm off the stress-free body `{}`, {}", path, 1e3 * off, body, consequence));
  }

  const Snapshot& snapshot_;
  std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> far_places(const Scenario& scenario, const Snapshot& snapshot) {
  FarPlaces far(snapshot);
  const AnnotationDefinition& annotations = scenario.teaching.annotations;
  for (std::size_t i = 0; i < annotations.labels.size(); ++i) {
    const LabelDefinition& label = annotations.labels[i];
    far.see_point(fmt::format("teaching.labels[{}].at", i + 1), label.body, label.at);
  }
  for (std::size_t i = 0; i < annotations.arrows.size(); ++i) {
    const ArrowDefinition& arrow = annotations.arrows[i];
    far.see_point(fmt::format("teaching.arrows[{}].at", i + 1), arrow.body, arrow.at);
  }
  for (std::size_t i = 0; i < scenario.view.highlights.size(); ++i) {
    const HighlightDefinition& mark = scenario.view.highlights[i];
    far.see_ball(fmt::format("teaching.highlights[{}].at", i + 1), mark.body, mark.center, mark.radius);
  }
  for (const RecordedPoint& point : scenario.record.points) {
    far.see_point(fmt::format("record.points.{}.at", point.name), point.body, {point.at[0], point.at[1], point.at[2]});
  }
  return std::move(far).notes();
}

}  // namespace thinwall
