#include "studio/scenario/StepLint.hpp"

#include "studio/scenario/TextNode.hpp"
#include "studio/schema/Quantity.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// Seconds: soft organs sway several times in it, which an implicit step damps away.
constexpr double kLongDynamicStep = 0.1;

/// Of the way in a step beyond the depth, so that sums of decimal numbers are no matter.
constexpr double kFarther = 1 + 1e-9;

void check_way(const CheckedMember& clip, const std::string& path, double step, Diagnostics& diagnostics) {
  if (clip.key != "palpate" && clip.key != "pierce") return;
  const CheckedValue *speed = clip.value.find("speed"), *depth = clip.value.find("depth");
  if (speed == nullptr || depth == nullptr) return;
  const double way = speed->number * step;
  if (way <= depth->number * kFarther) return;
  diagnostics.warning(speed->given ? speed->location : clip.location, path + ".speed",
                      "the tool goes " + format_like(way, "1 mm") + " in a `time_step` of " +
                          format_like(step, "1 ms") + ", farther than its `depth` of " +
                          format_like(depth->number, "1 mm") +
                          ": nothing of its way through the wall is seen; take a shorter step or a lower speed");
}

}  // namespace

void check_steps(const CheckedValue& root, Diagnostics& diagnostics) {
  const CheckedValue *simulation = root.find("simulation"), *timeline = root.find("timeline");
  const CheckedValue* step = simulation == nullptr ? nullptr : simulation->find("time_step");
  if (step == nullptr) return;
  const CheckedValue* analysis = simulation->find("analysis");
  if (analysis != nullptr && analysis->text == "dynamic" && step->number > kLongDynamicStep) {
    diagnostics.warning(step->location, "simulation.time_step",
                        format_like(step->number, "1 ms") +
                            " is long for a dynamic analysis, which damps what is faster; take 5 ms or the like, or "
                            "`analysis: quasi_static`");
  }
  for (std::size_t index = 0; timeline != nullptr && index < timeline->items.size(); ++index) {
    const CheckedValue& item = timeline->items[index];
    if (item.members.empty()) continue;
    check_way(item.members[0], member_path(item_path("timeline", index), item.members[0].key), step->number,
              diagnostics);
  }
}

}  // namespace thinwall
