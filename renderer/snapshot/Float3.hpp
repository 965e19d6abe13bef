#pragma once

#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// As snapshots and vertices that are drawn hold it.
inline Float3 float3(Vector3 a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

}  // namespace thinwall
