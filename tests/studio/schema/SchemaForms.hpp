#pragma once

#include <string>
#include <vector>

#include "studio/schema/Schema.hpp"

namespace thinwall {

/// A mapping of the format with one of its cases: what a set of keys can be tested on.
struct SchemaForm {
  const MappingSchema* mapping = nullptr;
  const CaseSchema* chosen = nullptr;  // nullptr for a mapping without cases

  std::string name() const;
  std::vector<KeySchema> keys() const;
};

/// All mappings of the table with all their cases.
std::vector<SchemaForm> all_schema_forms();

/// A right value in the words of a scenario, on one line.
std::string example_text(const ValueSchema& value);

/// A right mapping with every key of the form, `changed` with another value ("" takes it out).
std::string example_text(const SchemaForm& form, const std::string& changed_key = "", const std::string& changed = "");

}  // namespace thinwall
