#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// What lies below a scene.
enum class Ground {
  kFloor,  // of a studio, in the tone of the background
  kDrape,  // surgical cloth
  kTissue  // within a body, before an endoscope
};

/// Those in the open, in the words of the scenario format.
inline constexpr std::array<std::pair<std::string_view, Ground>, 2> kGrounds = {
    {{"floor", Ground::kFloor}, {"drape", Ground::kDrape}}};

/// The ground of that word, or nullptr.
const Ground* find_ground(std::string_view word);

/// Whether a ground, which is level, lies below what `gravity` (metres / second^2) pulls at: where there is none it
/// does, and not where it pulls sideways, by more than 45 degrees off -z, or up.
bool lies_below(const Double3& gravity);

}  // namespace thinwall
