#pragma once

namespace thinwall {

/// Coefficients of the second-order backward difference of a step h after an earlier one of another length:
/// y' = (now y1 + before y0 + earlier y-1) / h; without an earlier one it is the backward Euler difference.
struct BackwardDifference {
  double now, before, earlier;
};

/// Both in seconds; `previous_step` is zero when there is none.
inline BackwardDifference backward_difference(double step, double previous_step) {
  const double ratio = previous_step > 0 ? step / previous_step : 0;
  return {.now = (1 + 2 * ratio) / (1 + ratio), .before = -(1 + ratio), .earlier = ratio * ratio / (1 + ratio)};
}

}  // namespace thinwall
