#pragma once

#include <string>

#include "studio/golden/GoldenRenewal.hpp"
#include "studio/golden/GoldenRun.hpp"
#include "studio/recorder/PairedSource.hpp"
#include "tests/studio/FlatPainter.hpp"
#include "tests/studio/SyntheticRun.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {

/// A scenario that a formula simulates and flat painters draw; its light is the painters' gain.
inline Scenario golden_scene(double light = 1, const std::string& shear_modulus = "20000.0") {
  Scenario scenario;
  scenario.name = "sheet";
  scenario.title = "A sheet";
  scenario.resolved = R"({"bodies": {"organ": {"shear_modulus": )" + shear_modulus + R"(}}, "lights": {"key": )" +
                      std::to_string(light) + "}}";
  scenario.record.size = {.width = 96, .height = 64};
  scenario.goldens = {{.at = 0.1, .max = 8, .mean = 0.2, .why = "rounding"}};
  return scenario;
}

inline SourceFactory synthetic_source(SyntheticRunOptions options = {}) {
  return [options](const Scenario&) { return std::make_unique<SyntheticRun>(options); };
}

/// The same with a second take beside the first, of another parameter.
inline Scenario compared_scene(const std::string& set = "\"3 mm\"") {
  Scenario scenario = golden_scene();
  scenario.resolved.insert(1, R"("comparison": {"set": {"depth": )" + set + R"(}, "captions": ["deep", "shallow"]}, )");
  scenario.comparison = {.second = std::make_shared<const Scenario>(scenario)};
  scenario.view.comparison = std::make_shared<const TakeComparison>(TakeComparison{{"deep", "shallow"}, {}});
  return scenario;
}

inline SourceFactory synthetic_pair(SyntheticRunOptions first, SyntheticRunOptions second) {
  return [=](const Scenario&) {
    return pair_sources(std::make_unique<SyntheticRun>(first), std::make_unique<SyntheticRun>(second));
  };
}

/// Painters whose gain is the light that the scenario asks for, times that of the renderer.
inline ViewPainters view_painters(double renderer_gain = 1) {
  return [renderer_gain](const std::string& resolved) {
    const double light = std::stod(resolved.substr(resolved.find("\"key\": ") + 7));
    return flat_painters(renderer_gain * light);
  };
}

/// Approves and judges in a folder of its own.
class GoldenScene {
 public:
  std::filesystem::path folder() const { return folder_.path() / "goldens/sheet"; }
  GoldenRunOptions options(const SourceFactory& sources, const ViewPainters& painters) const {
    return {.sources = sources,
            .painters = painters,
            .goldens = folder_.path() / "goldens",
            .cache = {},
            .program = "1",
            .jobs = 1};
  }
  JudgedScenario judge(const Scenario& scenario, const SourceFactory& sources = synthetic_source(),
                       const ViewPainters& painters = view_painters()) const {
    return std::move(judge_scenarios({scenario}, options(sources, painters), [](const JudgedScenario&) {}).front());
  }
  void approve(const Scenario& scenario = golden_scene(), const SourceFactory& sources = synthetic_source()) const {
    const JudgedScenario judged = judge(scenario, sources);
    renew_golden(scenario, judged.pictures.pictures[0], judged.pictures.driver, folder(), "someone", "it is right");
  }
  const TemporaryFolder& temporary() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

}  // namespace thinwall
