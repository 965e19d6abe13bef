#pragma once

#include "engine/contact/PairDistance.hpp"

namespace thinwall {

/// Part of their distance that two parts keep at least when they move by a safe fraction.
constexpr double kKeptDistance = 0.1;

/// How far two parts that move along straight lines, each vertex by its `motion` (metres), may go without meeting: a
/// fraction from 0 to 1, after which and on the way to which they keep kKeptDistance of the distance that they had.
/// Conservative advancement (additive, Li, Kaufman and Jiang 2021): no step is longer than what the distance divided by
/// a bound of the relative speed allows, so that a meeting is never missed; the fraction may be smaller than the true
/// one.
double safe_fraction(PairKind kind, const PairCorners& corners, const PairCorners& motions);

/// Bound of how much the distance of the two can change during the motion, metres.
double relative_travel(PairKind kind, const PairCorners& motions);

}  // namespace thinwall
