#pragma once

#include <optional>

#include "renderer/camera/SeenScene.hpp"
#include "renderer/snapshot/MadeTopologies.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// A turn about the origin: what the axes of the turned scene are in that which was given, each of length one.
struct Turn {
  Vector3 x, y, z;
  Vector3 of(Vector3 place) const { return {dot(x, place), dot(y, place), dot(z, place)}; }
};

/// How a scene is turned before it is drawn, so that its gravity (metres / second^2) pulls along -z: floors are level
/// and lamps hang as rooms stand. Nothing where a ground lies below it as it is, see lies_below().
std::optional<Turn> turn_upright(const Double3& gravity);

/// Turns scenes one after the other.
class Turner {
 public:
  Snapshot turned(const Snapshot& snapshot, const Turn& turn);

 private:
  Double3 gravity_ = {0, 0, 0};
  MadeTopologies topologies_;
};

/// The same before the same cameras, of what `upright` has become by the turn.
SeenScene turned(const SeenScene& seen, const Snapshot& upright, const Turn& turn);

}  // namespace thinwall
