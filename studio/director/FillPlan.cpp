#include "studio/director/FillPlan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studio/scenario/InputError.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {

void FillPlan::add_to(BodyInput& input, double from, double to) const {
  const double begin = std::clamp(from, 0.0, clip.duration), end = std::clamp(to, 0.0, clip.duration);
  if (end <= begin) return;
  FluidInput& fluid = input.fluids[chamber];
  if (clip.pressure) {
    fluid.pressure = begin_pressure + end / clip.duration * (*clip.pressure - begin_pressure);
  } else {
    fluid.added += clip.added * (end - begin) / clip.duration;
  }
}

FillPlan plan_fill(const FillClip& clip, const Body& body, const SourceLocation& location) {
  const std::vector<ChamberModel>& chambers = body.model().chambers;
  const auto refuse = [&](const std::string& why) {
    throw InputErrors({{location, fmt::format("{}: the body {} {}", clip.drains ? "drain" : "inflate",
                                              in_backticks(clip.body), why)}});
  };
  if (chambers.empty()) refuse("holds no fluid that could be filled or drained");
  if (!clip.chamber && chambers.size() > 1) {
    refuse(fmt::format("has {} chambers: name one under `contents` and say which with `chamber`", chambers.size()));
  }
  FillPlan plan{.clip = clip};
  while (clip.chamber && chambers[plan.chamber].name != *clip.chamber) {
    if (++plan.chamber == static_cast<int>(chambers.size())) refuse("has no chamber " + in_backticks(*clip.chamber));
  }
  plan.begin_pressure = body.state().equilibrium.pressure[plan.chamber];
  return plan;
}

std::vector<double> load_factors(const BodyScenario& body, double time) {
  std::vector<double> factors;
  for (const LoadScenario& load : body.loads) {
    const auto& points = load.over;
    const auto later =
        std::find_if(points.begin(), points.end(), [&](const auto& point) { return point.first > time; });
    if (points.empty()) {
      factors.push_back(1);
    } else if (later == points.begin()) {
      factors.push_back(points.front().second);
    } else if (later == points.end()) {
      factors.push_back(points.back().second);
    } else {
      const auto& earlier = *(later - 1);
      const double part = (time - earlier.first) / (later->first - earlier.first);
      factors.push_back(earlier.second + part * (later->second - earlier.second));
    }
  }
  return factors;
}

}  // namespace thinwall
