#include "studio/recorder/ShortForceArrowNotes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/annotation/AnnotationDrawing.hpp"
#include "renderer/camera/PictureLayout.hpp"

namespace thinwall {

ShortForceArrowNotes::ShortForceArrowNotes(const std::vector<ForceArrowDefinition>& arrows) {
  for (const ForceArrowDefinition& arrow : arrows) arrows_.push_back({.definition = arrow});
}

void ShortForceArrowNotes::see(const Snapshot& snapshot, const Shot& shot, ImageSize size) {
  for (Arrow& arrow : arrows_) {
    if (arrow.was_seen || !arrow.definition.span.holds(snapshot.time)) continue;
    const std::optional<bool> is_shown =
        shows_force_arrow(arrow.definition, snapshot, shot.camera, main_box(shot, size).size);
    if (!is_shown) continue;
    // The other half of a split screen may show it.
    arrow.was_seen = shot.beside || *is_shown;
    const auto tool = std::ranges::find(snapshot.tools, arrow.definition.tool, &SnapshotTool::name);
    const auto [x, y, z] = tool->force;
    arrow.largest = std::max(arrow.largest, std::hypot(x, y, z));
  }
}

std::vector<std::string> ShortForceArrowNotes::notes() const {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < arrows_.size(); ++i) {
    const Arrow& arrow = arrows_[i];
    if (arrow.largest == 0 || arrow.was_seen) continue;
    notes.push_back(fmt::format(
        "teaching.force_arrows[{}]: is in no picture: the force of tool `{}`, {:.3g} N at most, makes it too short "
        "to be drawn; a smaller `full` than {:g} N, or a larger `length`, shows it",
        i + 1, arrow.definition.tool, arrow.largest, arrow.definition.full));
  }
  return notes;
}

}  // namespace thinwall
