#include "studio/director/BodyInputs.hpp"

#include "studio/director/Incising.hpp"

namespace thinwall {

BodyInput input_of(const BodyScenario& scenario, const Body& body, std::span<const ScheduledClip> clips,
                   const std::map<std::string, DirectedTool>& tools, double begin, double end) {
  BodyInput input{.load_factors = load_factors(scenario, end), .fluids = {}};
  input.fluids.resize(body.model().chambers.size());
  for (const ScheduledClip& clip : clips) {
    if (!clip.begun || clip.end <= begin + kTimeTolerance) continue;
    if (const auto* piercing = std::get_if<PiercingPlan>(&clip.plan)) {
      if (piercing->clip.body == scenario.name) input.needles.push_back(tools.at(piercing->clip.tool).index);
    }
    if (const auto* fill = std::get_if<FillPlan>(&clip.plan)) {
      if (fill->clip.body == scenario.name) fill->add_to(input, begin - clip.begin, end - clip.begin);
    }
    if (const auto* incision = std::get_if<IncisionPlan>(&clip.plan)) {
      if (incision->clip.body != scenario.name) continue;
      input.blades.push_back(tools.at(incision->clip.tool).index);
      if (input.blade) continue;
      const BladeStep step{
          .tool = tools.at(incision->clip.tool).index, .begin = begin - clip.begin, .end = end - clip.begin};
      input.blade = blade_input(*incision, body, step);
    }
  }
  return input;
}

}  // namespace thinwall
