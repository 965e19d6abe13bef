#pragma once

#include "renderer/shape/WoundFilm.hpp"

namespace thinwall {

/// The drops that fall from where runs of what was in a body leave its wall, `leaked` (metres^3) by `time` (seconds):
/// each run that has come to the end of its way lets one go at even times, for as long as there is fluid for it, and it
/// falls freely with `gravity` (metres / second^2, not zero). A pure function of the moment, as all films are.
Film falling_drops(const SnapshotSurface& surface, const WoundLayout& wounds, Vector3 gravity, double leaked,
                   double time);

/// The gravity that drops of a picture fall with: the snapshot's, that of the earth downwards where it has none.
Vector3 gravity_of_drops(const Snapshot& snapshot);

}  // namespace thinwall
