#include "studio/director/BodyNotes.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "studio/director/RunNotes.hpp"
#include "studio/organs/BodyBuilder.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {

std::vector<std::string> body_notes(const Scenario& scenario) {
  std::vector<std::string> notes;
  std::vector<Diagnostic> mistakes;
  for (const BodyScenario& body : scenario.bodies) {
    try {
      const BodyDefinition definition = build_body(body, notes);
      std::ranges::copy(thick_wall_notes(scenario, definition), std::back_inserter(notes));
    } catch (const InputErrors& errors) {
      mistakes.insert(mistakes.end(), errors.diagnostics().begin(), errors.diagnostics().end());
    }
  }
  if (!mistakes.empty()) throw InputErrors(std::move(mistakes));
  return notes;
}

}  // namespace thinwall
