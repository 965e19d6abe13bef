#include "studio/scenario/LoadScenario.hpp"

#include <algorithm>

#include "studio/scenario/CameraPass.hpp"
#include "studio/scenario/CameraReferences.hpp"
#include "studio/scenario/ComparisonPass.hpp"
#include "studio/scenario/Diagnostics.hpp"
#include "studio/scenario/ExpectationPass.hpp"
#include "studio/scenario/IncludePass.hpp"
#include "studio/scenario/LintPass.hpp"
#include "studio/scenario/LookPass.hpp"
#include "studio/scenario/ParameterPass.hpp"
#include "studio/scenario/ReferencePass.hpp"
#include "studio/scenario/ResolvedCameras.hpp"
#include "studio/scenario/ResolvedScenario.hpp"
#include "studio/scenario/ResolvedTeaching.hpp"
#include "studio/scenario/ScenarioBuilder.hpp"
#include "studio/scenario/TeachingReferences.hpp"
#include "studio/scenario/UnitPass.hpp"
#include "studio/scenario/YamlReader.hpp"
#include "studio/schema/Schema.hpp"

namespace thinwall {
namespace {

/// The file's nodes; throws when there is no mapping to go on with.
TextNode read_root(const std::filesystem::path& file, Diagnostics& diagnostics) {
  std::optional<TextNode> root = read_yaml_file(file, diagnostics);
  if (root && root->kind == NodeKind::kEmpty) {
    diagnostics.error({file, 1, 1}, "", "the file is empty; a scenario begins with `thinwall: 1`");
  } else if (root && root->kind != NodeKind::kMapping) {
    diagnostics.error(root->location, "",
                      "a scenario is a mapping that begins with `thinwall: 1`, not " + describe(*root));
  }
  if (!root || root->kind != NodeKind::kMapping) diagnostics.throw_errors(file);
  return std::move(*root);
}

enum class WhichTake { kFirst, kSecond };

/// One take's scenario, and what it is checked from.
struct LoadedTake {
  Scenario scenario;
  CheckedValue checked;
};

/// As the camera pass asks of one scenario.
CameraQuestions questions_about(const Scenario& scenario, const SurfaceAnswers& answers) {
  return {.inward_along = [&](const InciseClip& clip) -> Eigen::Vector3d {
            const auto cut = std::ranges::find(scenario.bodies, clip.body, &BodyScenario::name);
            return answers.inward_normal && cut != scenario.bodies.end() ? answers.inward_normal(*cut, clip)
                                                                         : Eigen::Vector3d::Zero();
          },
          .hidden_parts =
              [&](std::span<const Eigen::Vector3d> facings) {
                return answers.hidden_parts ? answers.hidden_parts(scenario, facings)
                                            : std::vector<double>(facings.size(), 0);
              }};
}

LoadedTake load_take(const std::filesystem::path& file, const Overrides& overrides, const SurfaceAnswers& answers,
                     WhichTake which) {
  Diagnostics diagnostics;
  TextNode root = read_root(file, diagnostics);
  include_pass(root, diagnostics);
  if (which == WhichTake::kSecond) change_for_comparison(root, diagnostics);
  parameter_pass(root, overrides, diagnostics,
                 which == WhichTake::kFirst ? UnusedParameters::kRefused : UnusedParameters::kAllowed);
  CheckedValue checked = unit_pass(root, scenario_schema(), diagnostics);
  reference_pass(checked, diagnostics);
  camera_references(checked, diagnostics);
  teaching_references(checked, diagnostics);
  expectation_pass(checked, diagnostics);
  lint_pass(checked, diagnostics);
  comparison_lint(checked, diagnostics);
  diagnostics.throw_errors(file);
  look_pass(checked);

  Scenario scenario = build_scenario(checked);
  camera_pass(checked, scenario.timeline, scenario.simulation.gravity, questions_about(scenario, answers));
  scenario.file = file;
  scenario.name = file.stem().string();
  if (scenario.title.empty()) scenario.title = scenario.name;
  sort_by_location(diagnostics.warnings, file);
  for (const Diagnostic& warning : diagnostics.warnings) {
    scenario.warnings.push_back(to_text(warning.location) + ": warning: " + warning.message);
  }
  scenario.resolved = resolved_scenario(checked, file.parent_path());
  read_cameras(scenario.resolved, scenario.view);
  read_teaching(scenario.resolved, scenario.teaching, scenario.view);
  return {std::move(scenario), std::move(checked)};
}

std::string caption_of(const CheckedValue& comparison, std::size_t half) {
  return comparison.at("captions").items[half].text;
}

}  // namespace

Scenario load_scenario(const std::filesystem::path& file,
                       const std::vector<std::pair<std::string, std::string>>& overrides,
                       const SurfaceAnswers& answers) {
  LoadedTake first = load_take(file, overrides, answers, WhichTake::kFirst);
  const CheckedValue* comparison = first.checked.find("comparison");
  if (comparison == nullptr) return std::move(first.scenario);
  LoadedTake second = load_take(file, overrides_for_comparison(overrides, *comparison), answers, WhichTake::kSecond);
  std::vector<std::string>& told = first.scenario.warnings;
  for (const std::string& warning : second.scenario.warnings) {
    if (std::ranges::find(told, warning) == told.end()) told.push_back(warning);
  }
  if (second.scenario.resolved == first.scenario.resolved) {
    told.push_back(to_text(comparison->at("set").location) +
                   ": warning: comparison.set: both takes are alike: what is set is what the first take has");
  }
  second.scenario.goldens.clear();
  second.scenario.expectations.clear();
  const std::array<std::string, 2> captions{caption_of(*comparison, 0), caption_of(second.checked.at("comparison"), 1)};
  const auto shared = std::make_shared<const Scenario>(std::move(second.scenario));
  first.scenario.comparison = {captions, shared};
  first.scenario.view.comparison = std::make_shared<const TakeComparison>(TakeComparison{captions, shared->view});
  return std::move(first.scenario);
}

}  // namespace thinwall
