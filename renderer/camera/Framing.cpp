#include "renderer/camera/Framing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace thinwall {
namespace {

/// Part of the picture that the rest surfaces fill, in clip coordinates from -1 to 1; the rest is for overlays.
struct Window {
  double left = -0.80;
  double right = 0.60;
  double bottom = -0.64;
  double top = 0.56;
};

/// The same in pictures less wide than 16 by 9, where captions have no room between the panels and stand above them.
constexpr Window kNarrowWindow = {.bottom = -0.25, .top = 0.66};
constexpr double kNarrow = 1.65;  // width over height, as of caption_space() of Overlay.cpp
constexpr double kHalf = 1;       // below that, halves of pictures, which have room for captions, and upright pictures

/// Within an endoscope's field stop, for pictures of 16 by 9.
constexpr Window kRoundWindow = {.left = -0.54, .right = 0.54, .bottom = -0.72, .top = 0.70};

/// Which walls may grow into, nearer to overlays and borders, before the camera goes back.
constexpr Window kGrowthWindow = {.left = -0.92, .right = 0.80, .bottom = -0.78, .top = 0.80};
constexpr Window kNarrowGrowthWindow = {.left = -0.92, .right = 0.80, .bottom = -0.35, .top = 0.80};
constexpr Window kRoundGrowthWindow = {.left = -0.58, .right = 0.58, .bottom = -0.80, .top = 0.80};

/// Nearest position along the line of sight from which all points lie within one side pair of the window. With a the
/// coordinate of a point across and c towards the camera, at camera coordinates (x, z) the point lies inside when
/// low * tangent * (z - c) <= a - x <= high * tangent * (z - c): two half planes in (x, z) for each point.
struct Fit {
  double low = -1, high = 1, tangent = 1;
  double largest = -std::numeric_limits<double>::max();  // of a + high * tangent * c over the points
  double smallest = std::numeric_limits<double>::max();  // of a + low * tangent * c

  void include(double across, double toward) {
    largest = std::max(largest, across + high * tangent * toward);
    smallest = std::min(smallest, across + low * tangent * toward);
  }
  double distance() const { return (largest - smallest) / ((high - low) * tangent); }
  double middle(double distance) const { return 0.5 * (largest + smallest - (low + high) * tangent * distance); }
  /// The nearest to `place` from which all points are inside.
  double nearest_to(double place, double distance) const {
    return std::max(largest - high * tangent * distance, std::min(place, smallest - low * tangent * distance));
  }
};

/// Across the picture and up.
struct Fits {
  Fit x, y;
  double distance() const { return std::max(x.distance(), y.distance()); }
  void include(const Camera& camera, Vector3 point) {
    const double toward = -dot(point, camera.forward);
    x.include(dot(point, camera.right), toward);
    y.include(dot(point, camera.up), toward);
  }
};

Fits fit(const Camera& camera, const Window& window, std::span<const Vector3> points) {
  Fits fits{.x = {.low = window.left, .high = window.right, .tangent = camera.tangent_x},
            .y = {.low = window.bottom, .high = window.top, .tangent = camera.tangent_y}};
  for (const Vector3& point : points) fits.include(camera, point);
  return fits;
}

struct Windows {
  Window rest, growth;
};

Windows windows_of(const Camera& camera) {
  if (camera.kind == CameraKind::kEndoscope) return {kRoundWindow, kRoundGrowthWindow};
  const double aspect = camera.tangent_x / camera.tangent_y;
  if (aspect >= kHalf && aspect < kNarrow) return {kNarrowWindow, kNarrowGrowthWindow};
  return {Window{}, kGrowthWindow};
}

/// What is farthest from the axis of a turn: of each sector and height the outermost point, for all points at all
/// angles would take longer than a picture.
std::vector<Vector3> outermost(const std::vector<Vector3>& points, const Turn& turn) {
  constexpr int kSectors = 36, kHeights = 8;
  const Vector3 first = perpendicular(turn.axis), second = cross(turn.axis, first);
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const Vector3& point : points) {
    const double height = dot(point - turn.center, turn.axis);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  const double rise = std::max(high - low, 1e-12);
  std::array<const Vector3*, kSectors * kHeights> chosen{};
  std::array<double, kSectors * kHeights> farthest{};
  for (const Vector3& point : points) {
    const Vector3 offset = point - turn.center;
    const double x = dot(offset, first), y = dot(offset, second);
    const double round = 0.5 + std::atan2(y, x) / (2 * std::numbers::pi);
    const double up = (dot(offset, turn.axis) - low) / rise;
    const int sector = std::min(static_cast<int>(kSectors * round), kSectors - 1);
    const auto cell =
        static_cast<std::size_t>(kHeights * sector + std::min(static_cast<int>(kHeights * up), kHeights - 1));
    if (chosen[cell] != nullptr && std::hypot(x, y) <= farthest[cell]) continue;
    chosen[cell] = &point;
    farthest[cell] = std::hypot(x, y);
  }
  std::vector<Vector3> outer;
  for (const Vector3* point : chosen) {
    if (point != nullptr) outer.push_back(*point);
  }
  return outer;
}

/// As a camera sees them that goes round: the same as if they went the other way.
void include_turned(const Camera& camera, const SceneExtent& extent, const Turn& turn, Fits& fits) {
  constexpr double kStep = 5 * std::numbers::pi / 180;
  const double way = std::min(std::abs(turn.angle), 2 * std::numbers::pi);
  const std::vector<Vector3> outer = outermost(extent.rest_points, turn);
  const int steps = static_cast<int>(std::ceil(way / kStep));
  for (int k = 1; k <= steps; ++k) {
    const double angle = -std::copysign(std::min(k * kStep, way), turn.angle);
    for (const Vector3& point : outer) {
      fits.include(camera, turn.center + turned(point - turn.center, turn.axis, angle));
    }
  }
}

}  // namespace

void frame(Camera& camera, const SceneExtent& extent, const Turn& turn) {
  constexpr double kFarthest = 3;
  const auto [window, growth_window] = windows_of(camera);
  Fits rest = fit(camera, window, extent.rest_points);
  if (turn.angle != 0) include_turned(camera, extent, turn, rest);
  double distance = rest.distance();
  double x = rest.x.middle(distance), y = rest.y.middle(distance);
  const Fits grown = fit(camera, growth_window, extent.grown_points);
  if (!extent.grown_points.empty()) {
    const double to_center = distance + dot(extent.center, camera.forward);
    const double farthest = distance + (kFarthest - 1) * std::max(to_center, 0.0);
    distance = std::clamp(grown.distance(), distance, farthest);
    x = grown.x.nearest_to(rest.x.middle(distance), distance);
    y = grown.y.nearest_to(rest.y.middle(distance), distance);
  }
  camera.position = x * camera.right + y * camera.up - distance * camera.forward;
}

}  // namespace thinwall
