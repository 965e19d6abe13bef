#pragma once

#include <span>
#include <string_view>

#include "renderer/look/TissueLook.hpp"

namespace thinwall {

/// The look of a kind of organ.
struct OrganLook {
  std::string_view organ;  // the word of the scenario format
  std::string_view documentation;
  TissueLook look;
};

/// One for each kind of organ; the first is that of any tissue.
std::span<const OrganLook> organ_looks();

/// The look of the kind `organ`, or nullptr when there is none of that name.
const TissueLook* find_organ_look(std::string_view organ);

}  // namespace thinwall
