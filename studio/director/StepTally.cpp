#include "studio/director/StepTally.hpp"

#include <fmt/format.h>

namespace thinwall {
namespace {

/// Iterations of one step above which it is a laborious one; a slack sheet that is cut crosswise takes some twenty.
constexpr int kManyIterations = 40;

/// Such steps are told of where there are at least so many of them, and this part of all: they take most of the time.
constexpr long kLeastLaborious = 20;
constexpr double kLaboriousPart = 0.1;

}  // namespace

void StepTally::Count::add(const std::string& body_of_step, double time) {
  if (steps > 0 && time == last) return;
  last = time;
  if (steps++ > 0) return;
  first = time;
  body = body_of_step;
}

void StepTally::note(const std::string& body, const BodyStepReport& report, double time) {
  if (report.halvings > 0) divided_.add(body, time);
  if (report.slowed) slowed_.add(body, time);
  if (report.loose) loose_.add(body, time);
  if (report.unstable) unstable_.add(body, time);
  if (report.held) held_.add(body, time);
  if (report.crumpled) crumpled_.add(body, time);
  if (report.newton_iterations > kManyIterations) laborious_.add(body, time);
}

std::vector<std::string> StepTally::warnings(long steps) const {
  std::vector<std::string> all;
  const auto tell = [&](const Count& count, const std::string& what) {
    if (count.steps == 0) return;
    all.push_back(fmt::format("{} of {} steps {} (first: body `{}`, {:.4g} s)", count.steps, steps, what, count.body,
                              count.first));
  };
  tell(divided_, "had to be divided to be solved");
  tell(slowed_,
       "slowed what nothing holds, as flaps of a cut wall or a wall that slips off a tool; what that took counts as "
       "`numerical_J`");
  tell(loose_, "end with a residual above the tolerance, as crumpled and buckled walls may; `residual_N` tells it");
  tell(
      unstable_,
      "end in an equilibrium that is not stable: the wall would buckle there; a small load across it or an uneven mesh "
      "shows where to, and `analysis: dynamic` how; a membrane that is pressed along itself wrinkles with "
      "`tension_field: true`");
  tell(held_,
       "hold a body against what its weight and loads would turn it by, as it was not brought to rest: its attitude is "
       "no equilibrium; hold more of it (`fixed`), or let it come to rest with `analysis: dynamic` and `damping`");
  tell(crumpled_,
       "crumpled a wall under a blade that pressed it along itself; from there on it wrinkles as with `tension_field`");
  if (laborious_.steps >= kLeastLaborious &&
      static_cast<double>(laborious_.steps) >= kLaboriousPart * static_cast<double>(steps)) {
    tell(laborious_,
         fmt::format("took more than {} iterations each, as walls that hang slack and flutter do; in a "
                     "dynamic analysis `damping: {{ mass_rate: 40 Hz, stiffness_time: 5 ms }}` in `wall` calms "
                     "them, where it is slight beside what you look for, and a looser `tolerance` takes "
                     "fewer",
                     kManyIterations));
  }
  return all;
}

}  // namespace thinwall
