#include "engine/material/WallLaw.hpp"

#include <array>

#include "engine/material/WallLawRows.hpp"

namespace thinwall {

std::span<const WallLaw> wall_laws() {
  // Built on first use, because the rows are initialised in other files.
  static const std::array<WallLaw, 7> laws = {kStVenantKirchhoff, kNeoHookean, kMooneyRivlin, kGent, kOgden, kFung,
                                              kHolzapfel};
  return laws;
}

const WallLaw* find_wall_law(std::string_view name) {
  for (const WallLaw& law : wall_laws()) {
    if (law.name == name) return &law;
  }
  return nullptr;
}

}  // namespace thinwall
