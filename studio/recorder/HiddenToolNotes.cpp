#include "studio/recorder/HiddenToolNotes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "renderer/annotation/MaterialPoint.hpp"
#include "renderer/camera/Camera.hpp"
#include "renderer/camera/PictureLayout.hpp"
#include "renderer/camera/SceneExtent.hpp"
#include "renderer/shape/WithinBody.hpp"

namespace thinwall {
namespace {

/// On the tool, where it comes out of the wall that it dents or has gone into, metres.
Vector3 place_above_wall(const SnapshotTool& tool) {
  constexpr double kLeast = 1e-3;
  const double back = std::max(tool.depth, 0.0) + std::max(tool.radius, kLeast);
  return vector3(tool.tip) - back * vector3(tool.direction);
}

bool is_in_picture(const Camera& camera, Vector3 place, ImageSize size) {
  const auto pixel = camera.pixel(place, size);
  return pixel && camera.shows(*pixel, size);
}

/// The first of the free sides that have the most free ones beside them; nothing where none is free.
std::optional<std::size_t> most_open(std::span<const bool> is_free) {
  const std::size_t count = is_free.size();
  std::optional<std::size_t> best;
  int most = -1;
  for (std::size_t side = 0; side < count; ++side) {
    const int beside = is_free[(side + 1) % count] + is_free[(side + count - 1) % count];
    if (!is_free[side] || beside <= most) continue;
    best = side;
    most = beside;
  }
  return best;
}

}  // namespace

/// Round the scene, as steeply down as a camera looks of which nothing is told.
Double3 HiddenToolNotes::facing(std::size_t side) {
  constexpr double kDown = 0.54;  // sine of 33 degrees
  const double azimuth = 2 * std::numbers::pi * static_cast<double>(side) / kSides;
  const double level = std::sqrt(1 - kDown * kDown);
  return {level * std::cos(azimuth), level * std::sin(azimuth), -kDown};
}

void HiddenToolNotes::see(const Snapshot& snapshot, const Shot& shot, ImageSize size) {
  const auto is_of_interest = [&](const SnapshotTool& tool) {
    const auto noted = by_tool_.find(tool.name);
    return tool.touches() && (noted == by_tool_.end() || !noted->second.was_seen);
  };
  if (std::ranges::none_of(snapshot.tools, is_of_interest)) return;
  const SceneExtent extent = scene_extent(snapshot);
  const ImageSize main = main_box(shot, size).size;
  const Camera camera = resolve_camera(shot.camera, extent, main, snapshot.time);
  const Vector3 eye = camera.position;
  // From there one sees what a tool does to the wall.
  const bool is_within =
      std::ranges::any_of(snapshot.surfaces, [&](const SnapshotSurface& body) { return lies_within(body, eye); });
  for (const SnapshotTool& tool : snapshot.tools) {
    if (!is_of_interest(tool)) continue;
    const Vector3 place = place_above_wall(tool);
    Touching& touching =
        by_tool_.try_emplace(tool.name, Touching{.since = snapshot.time, .place = vector3(tool.tip)}).first->second;
    const bool has_others = shot.beside || shot.inset;
    if (!has_others && !is_in_picture(camera, place, main) && !is_in_picture(camera, vector3(tool.tip), main)) continue;
    touching.was_in_picture = true;
    touching.was_seen = is_within || has_others || !is_hidden(place, eye, snapshot);
    for (std::size_t side = 0; side < kSides && !touching.was_seen; ++side) {
      const Vector3 from_there = place - 2 * extent.size * vector3(facing(side));
      touching.is_free[side] = touching.is_free[side] && !is_hidden(place, from_there, snapshot);
    }
  }
}

std::vector<std::string> HiddenToolNotes::notes() const {
  std::vector<std::string> notes;
  for (const auto& [tool, touching] : by_tool_) {
    if (touching.was_seen) continue;
    if (!touching.was_in_picture) {
      const auto& [x, y, z] = touching.place;
      // A sum with zero is never the negative one.
      notes.push_back(fmt::format(
          "camera: where tool `{}` touches lies beside the picture in all pictures of that, from {:.4g} s on; "
          "`target: [{:.3g} mm, {:.3g} mm, {:.3g} mm]` brings it into the middle",
          tool, touching.since, 1e3 * x + 0.0, 1e3 * y + 0.0, 1e3 * z + 0.0));
      continue;
    }
    std::string cure = "another `position`, or `facing` from above or below, may show it";
    if (const std::optional<std::size_t> side = most_open(touching.is_free)) {
      const auto [x, y, z] = facing(*side);
      cure = fmt::format("without `position` and with `facing: [{:.2f}, {:.2f}, {:.2f}]` it shows it", x, y, z);
    }
    notes.push_back(
        fmt::format("camera: a wall hides where tool `{}` touches in all pictures of that, from {:.4g} s on; {}", tool,
                    touching.since, cure));
  }
  return notes;
}

}  // namespace thinwall
