#include "tests/studio/schema/SchemaForms.hpp"

#include <algorithm>

namespace thinwall {
namespace {

void collect(const ValueSchema& value, std::vector<SchemaForm>& forms);

void collect(const MappingSchema& mapping, std::vector<SchemaForm>& forms) {
  if (mapping.cases.empty()) forms.push_back({&mapping, nullptr});
  for (const CaseSchema& row : mapping.cases) {
    forms.push_back({&mapping, &row});
    for (const KeySchema& key : row.keys) collect(key.value, forms);
  }
  for (const KeySchema& key : mapping.keys) collect(key.value, forms);
}

void collect(const ValueSchema& value, std::vector<SchemaForm>& forms) {
  for (const ValueSchema& item : value.item) collect(item, forms);
  for (const MappingSchema& mapping : value.mappings) collect(mapping, forms);
}

std::string first_form_text(const MappingSchema& mapping) {
  return example_text(SchemaForm{&mapping, mapping.cases.empty() ? nullptr : &mapping.cases[0]});
}

std::string list_text(const ValueSchema& list) {
  std::string text;
  for (std::size_t count = 0; count < std::max<std::size_t>(1, list.minimum_items); ++count) {
    text += (count == 0 ? "" : ", ") + example_text(item_of(list, count));
  }
  return "[" + text + "]";
}

}  // namespace

std::string SchemaForm::name() const {
  return mapping->name + (chosen == nullptr ? "" : " " + chosen->word) + " " + mapping->keys[0].key;
}

std::vector<KeySchema> SchemaForm::keys() const {
  std::vector<KeySchema> keys = mapping->keys;
  if (chosen != nullptr) keys.insert(keys.end(), chosen->keys.begin(), chosen->keys.end());
  return keys;
}

std::vector<SchemaForm> all_schema_forms() {
  std::vector<SchemaForm> forms;
  collect(scenario_schema(), forms);
  return forms;
}

std::string example_text(const ValueSchema& value) {
  switch (value.kind) {
    case ValueKind::kText:
      return "some words";
    case ValueKind::kPath:
      return "folder/file.obj";
    case ValueKind::kName:
      return "somebody";
    case ValueKind::kWord:
      return value.words[0];
    case ValueKind::kBoolean:
      return "true";
    case ValueKind::kInteger:
    case ValueKind::kQuantity:
    case ValueKind::kAnyQuantity:
      return value.example;
    case ValueKind::kDirection:
      return "[0, 0, -2]";
    case ValueKind::kAxes:
      return "xz";
    case ValueKind::kList:
      return list_text(value);
    case ValueKind::kMapping:
      return first_form_text(value.mappings[0]);
    case ValueKind::kNamedMappings:
      return "{ somebody: " + first_form_text(value.mappings[0]) + " }";
    case ValueKind::kParameters:
    case ValueKind::kChanges:
      return "{ size: 1 mm }";
  }
  return "";
}

std::string example_text(const SchemaForm& form, const std::string& changed_key, const std::string& changed) {
  std::string text;
  for (const KeySchema& key : form.keys()) {
    std::string value = key.key == form.mapping->selector ? form.chosen->word : example_text(key.value);
    if (key.key == changed_key) value = changed;
    if (!value.empty()) text += (text.empty() ? "" : ", ") + key.key + ": " + value;
  }
  return "{ " + text + " }";
}

}  // namespace thinwall
