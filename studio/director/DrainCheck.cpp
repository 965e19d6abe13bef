#include "studio/director/DrainCheck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "studio/scenario/InputError.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// What a clip drains, in words.
std::string holder(const FillClip& clip) {
  const std::string body = "body " + in_backticks(clip.body);
  return clip.chamber ? "chamber " + in_backticks(*clip.chamber) + " of " + body : body;
}

}  // namespace

void refuse_overdrawn(std::span<const Clip> timeline, std::span<const ScheduledClip> clips,
                      const std::function<const Body&(const std::string& name)>& body_named) {
  std::vector<std::size_t> order(clips.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return clips[k].begin; });
  std::map<std::pair<std::string, int>, std::optional<double>> held;  // metres^3, by body and chamber
  std::vector<Diagnostic> mistakes;
  for (const std::size_t k : order) {
    const auto* fill = std::get_if<FillPlan>(&clips[k].plan);
    if (fill == nullptr) continue;
    const std::string& body = fill->clip.body;
    const Eigen::VectorXd& volumes = body_named(body).state().fluid_volume;
    // Through orifices chambers share what they hold.
    const bool shared = !body_named(body).model().definition.fluid.orifices.empty();
    std::optional<double>& volume =
        held.try_emplace({body, shared ? -1 : fill->chamber}, shared ? volumes.sum() : volumes[fill->chamber])
            .first->second;
    if (fill->clip.pressure) volume.reset();
    if (!volume) continue;
    const double drained = -fill->clip.added;
    if (drained >= *volume) {
      mistakes.push_back({timeline[k].location,
                          fmt::format("timeline[{}].drain: `by` = {:.4g} ml is not less than the {:.4g} ml that {} "
                                      "holds when the clip begins; drain less, or fill in more before",
                                      k + 1, 1e6 * drained, 1e6 * *volume,
                                      shared ? "body " + in_backticks(body) : holder(fill->clip))});
      volume.reset();
      continue;
    }
    *volume -= drained;
  }
  if (!mistakes.empty()) throw InputErrors(std::move(mistakes));
}

}  // namespace thinwall
