#include "studio/director/IntegratorEnergy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace thinwall {
namespace {

/// Part of the largest other term above which results are in doubt: forces, which are energies over ways, are then off
/// by as much, more than meshes and materials usually leave them.
constexpr double kMostPart = 0.1;

/// Part of the whole in one step from which on that step is to blame, not all of them.
constexpr double kOneStep = 0.3;

/// What helps against one step that has taken so much. A wall that snaps through gives off energy, which a sequence of
/// equilibria has no motion for.
std::string cure_of_jump(double jump, Analysis analysis, bool has_tools) {
  const std::string snap = analysis == Analysis::kQuasiStatic && jump > 0
                               ? "where a wall snaps through there it gives that off, which is no error; else "
                               : "";
  return snap + (has_tools ? "move or turn the tool more slowly there, or " : "") + "take a shorter `time_step`";
}

}  // namespace

void IntegratorEnergy::note(const Body& body, double time) {
  note(body.model().definition.name, body.state().books, body.model().least_energy(), time);
}

void IntegratorEnergy::note(const std::string& body, const EnergyBooks& books, double none, double time) {
  const auto [place, is_first] = watches_.try_emplace(body);
  Watch& watch = place->second;
  if (is_first) watch.gravity = books.gravity;
  watch.none = none;
  EnergyBooks since = books;
  since.gravity -= watch.gravity;
  watch.largest = std::max(watch.largest, since.largest());
  const double step = books.numerical - watch.last;
  watch.last = books.numerical;
  if (std::abs(step) > std::abs(watch.jump)) watch.jump = step, watch.at = time;
  if (std::abs(books.numerical) > std::abs(watch.most)) watch.most = books.numerical;
}

std::vector<std::string> IntegratorEnergy::warnings(Analysis analysis, bool has_tools) const {
  std::vector<std::string> all;
  for (const auto& [body, watch] : watches_) {
    if (std::abs(watch.most) <= std::max(watch.none, kMostPart * watch.largest)) continue;
    const bool jumped = std::abs(watch.jump) > kOneStep * std::abs(watch.most);
    all.push_back(fmt::format(
        "body `{}`: `numerical_J`, what the integrator takes, comes to {:.3g} J, {:.0f} % of the largest other energy: "
        "results are in doubt; {} ({:.3g} J) in the step to {:.4g} s; {}",
        body, watch.most, 100 * std::abs(watch.most) / watch.largest,
        jumped ? "it jumped" : "it grew over many steps, most", watch.jump, watch.at,
        jumped ? cure_of_jump(watch.jump, analysis, has_tools)
               : "take a shorter `time_step`, in dynamics or a `step_error`"));
  }
  return all;
}

}  // namespace thinwall
