#include "studio/recorder/GroundNotes.hpp"

#include "renderer/camera/AskedGround.hpp"
#include "renderer/look/Ground.hpp"

namespace thinwall {

void GroundNotes::see(const Snapshot& snapshot, const Shot& shot) {
  is_missed_ = is_missed_ || (asks_for_ground(view_, shot.camera) && !lies_below(snapshot.gravity));
}

std::vector<std::string> GroundNotes::notes() const {
  if (!is_missed_) return {};
  return {
      "gravity does not pull along -z, across which floors and drapes lie, so pictures have none; `turned` in "
      "`surface` brings a body upright"};
}

}  // namespace thinwall
