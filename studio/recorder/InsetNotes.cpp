#include "studio/recorder/InsetNotes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/PictureLayout.hpp"
#include "renderer/camera/SceneExtent.hpp"
#include "renderer/image/PictureCorner.hpp"

namespace thinwall {
namespace {

bool holds(const PictureBox& box, const std::array<double, 2>& pixel) {
  return pixel[0] >= box.left && pixel[0] < box.left + box.size.width && pixel[1] >= box.top &&
         pixel[1] < box.top + box.size.height;
}

}  // namespace

void InsetNotes::see(const Snapshot& snapshot, const Shot& shot, ImageSize size) {
  if (!shot.inset || std::ranges::none_of(snapshot.tools, &SnapshotTool::touches)) return;
  const ImageSize main = main_box(shot, size).size;
  const Camera camera = resolve_camera(shot.camera, scene_extent(snapshot), main, snapshot.time);
  for (const SnapshotTool& tool : snapshot.tools) {
    const auto pixel = camera.pixel(vector3(tool.tip), main);
    if (!tool.touches() || !pixel) continue;
    for (std::size_t k = 0; k < kCornerWords.size(); ++k) {
      Shot placed = shot;
      placed.corner = static_cast<PictureCorner>(k);
      if (!holds(inset_box(placed, size), *pixel)) continue;
      is_free_[k] = false;
      if (placed.corner == shot.corner) covered_since_.try_emplace(tool.name, snapshot.time);
    }
  }
}

std::vector<std::string> InsetNotes::notes() const {
  const auto free = std::ranges::find(is_free_, true);
  const std::string cure =
      free == is_free_.end()
          ? "no corner is free; another `camera`, or `beside`, shows both"
          : fmt::format("`corner: {}` leaves it free", kCornerWords[static_cast<std::size_t>(free - is_free_.begin())]);
  std::vector<std::string> notes;
  for (const auto& [tool, time] : covered_since_) {
    notes.push_back(fmt::format(
        "cuts: the small picture (`inset`) covers the tip of tool `{}` while it touches, first at {:.4g} s; {}", tool,
        time, cure));
  }
  return notes;
}

}  // namespace thinwall
