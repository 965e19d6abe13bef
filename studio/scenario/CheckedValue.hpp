#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "studio/scenario/Scenario.hpp"
#include "studio/schema/Quantity.hpp"
#include "studio/schema/Range.hpp"

namespace thinwall {

enum class CheckedKind { kBoolean, kInteger, kNumber, kText, kPath, kList, kMapping };

struct CheckedMember;

/// A value of a scenario that was read against the schema: SI numbers, known words, defaults filled in. What was wrong
/// is told as an error and left out of its mapping or list.
struct CheckedValue {
  CheckedKind kind = CheckedKind::kMapping;
  SourceLocation location = {};  // of the text; for a default, of the key of the mapping that lacks it
  bool given = true;             // false for a default
  bool boolean = false;
  double number = 0;                        // kInteger, kNumber, SI
  Dimension dimension = {};                 // kNumber where the schema leaves it open
  std::string text = {};                    // kText; kPath: absolute or relative to the working directory
  std::vector<CheckedValue> items = {};     // kList
  std::vector<CheckedMember> members = {};  // kMapping: keys in the order of the schema, names in the order of the file
  std::vector<std::string> wrong_keys = {};  // kMapping: keys that were given and left out
  Range range = {};                          // kMapping in place of a quantity: what each of its numbers must be
  std::string example = {};                  // the same: an example of the quantity

  /// The member's value, or nullptr.
  const CheckedValue* find(std::string_view key) const;
  CheckedValue* find(std::string_view key);

  /// The member's value; it must be there.
  const CheckedValue& at(std::string_view key) const;

  /// Whether the key was given with a value that is wrong.
  bool has_wrong(std::string_view key) const;
};

struct CheckedMember {
  std::string key = {};
  SourceLocation location = {};  // of the key
  CheckedValue value = {};
};

}  // namespace thinwall
