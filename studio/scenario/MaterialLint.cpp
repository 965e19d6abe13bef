#include "studio/scenario/MaterialLint.hpp"

#include "engine/material/WallLaw.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// Adds the parameters that are there; false when one is missing, wrong or a field, which is looked at triangle by
/// triangle when the body is made.
bool collect(const WallLaw& law, const CheckedValue& mapping, std::vector<double>& parameters) {
  for (const LawParameter& parameter : law.parameters) {
    const CheckedValue* value = mapping.find(parameter.name);
    if (value == nullptr || value->kind != CheckedKind::kNumber) return false;
    parameters.push_back(value->number);
  }
  return true;
}

std::string complaint_of(const WallLaw& law, const CheckedValue& material) {
  if (law.complaint == nullptr) return "";
  std::vector<double> parameters;
  if (law.terms.empty()) return collect(law, material, parameters) ? law.complaint(parameters) : "";
  const CheckedValue* terms = material.find(law.terms);
  if (terms == nullptr || terms->items.empty()) return "";
  for (const CheckedValue& term : terms->items) {
    if (!collect(law, term, parameters)) return "";
  }
  return law.complaint(parameters);
}

}  // namespace

void check_material(const CheckedMember& body, const std::string& path, Diagnostics& diagnostics) {
  const CheckedValue* wall = body.value.find("wall");
  const CheckedValue* material = wall == nullptr ? nullptr : wall->find("material");
  const CheckedValue* word = material == nullptr ? nullptr : material->find("law");
  const WallLaw* law = word == nullptr ? nullptr : find_wall_law(word->text);
  if (law == nullptr) return;
  const std::string complaint = complaint_of(*law, *material);
  if (!complaint.empty()) diagnostics.error(material->location, path + ".wall.material", complaint);
  if (law->has_fibres && wall->find("fibres") == nullptr && !wall->has_wrong("fibres")) {
    diagnostics.error(word->location, path + ".wall.material.law",
                      in_backticks(std::string(law->name)) +
                          " must know where its fibres lie; write `fibres: { along: [1, 0, 0] }` in the wall");
  }
  const CheckedValue *field = wall->find("tension_field"), *model = wall->find("model");
  if (field != nullptr && field->boolean && model != nullptr && model->text == "shell") {
    diagnostics.error(field->location, path + ".wall.tension_field",
                      "a shell wrinkles by itself; leave `tension_field` out, or write `model: membrane`");
  }
}

}  // namespace thinwall
