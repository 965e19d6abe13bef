#pragma once

namespace thinwall {

/// What of a body is seen.
enum class TissueSide {
  kOutside,
  kRim,        // where the wall is cut through or ends
  kLining,     // the inner side
  kCap,        // closes the fluid where no wall is
  kCapLining,  // that from within
  kBed         // what an open sheet of skin lies on
};

}  // namespace thinwall
