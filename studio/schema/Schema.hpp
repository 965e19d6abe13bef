#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studio/schema/Quantity.hpp"
#include "studio/schema/Range.hpp"
#include "studio/schema/UsualRanges.hpp"

namespace thinwall {

enum class ValueKind {
  kText,           // one or more characters
  kPath,           // of a file, relative to the file that names it
  kWord,           // one of `words`
  kName,           // of a body, a tool or another thing of the scenario's own
  kBoolean,        // true or false
  kInteger,        // in `range`
  kQuantity,       // of `dimension` in `range`
  kAnyQuantity,    // of a dimension that another key tells
  kDirection,      // three numbers, not all zero; made a unit vector
  kAxes,           // some of x, y, z: `xz`
  kList,           // of `item`
  kMapping,        // one of `mappings`, told apart by their first keys
  kNamedMappings,  // names of the user's own to `mappings[0]`
  kParameters,     // names of the user's own to texts or lists
  kChanges         // parameters, or paths of values, to what stands there instead
};

struct MappingSchema;

/// What may stand as the value of a key.
struct ValueSchema {
  ValueKind kind = ValueKind::kText;
  Dimension dimension = {};
  Range range = {};
  const UsualRange* usual = nullptr;    // kQuantity: what is beyond it is told of
  std::string example = {};             // in the words of a scenario
  std::string page_words = {};          // in the reference page, where a mapping stands for several that are alike
  std::vector<std::string> words = {};  // kWord
  bool bare_unit = false;               // kQuantity: `mm` stands for `1 mm`
  bool single = false;                  // kList: an item by itself stands for a list of one
  int multiple_of = 1;                  // kInteger
  std::size_t minimum_items = 0;        // kList, kNamedMappings
  std::size_t maximum_items = std::numeric_limits<std::size_t>::max();
  std::vector<ValueSchema> item = {};        // kList: one, or one for each place of a list of fixed size
  std::vector<MappingSchema> mappings = {};  // kMapping, kNamedMappings; for other kinds a form as mapping besides
};

/// A key of a mapping.
struct KeySchema {
  std::string key = {};
  ValueSchema value = {};
  bool needed = false;
  std::optional<std::string> fallback =
      {};  // the default in the words of a scenario; none: absent has a meaning of its own
  std::string documentation = {};
};

/// Further keys that belong to one word of a mapping's selecting key.
struct CaseSchema {
  std::string word = {};
  std::string documentation = {};
  std::vector<KeySchema> keys = {};
};

/// A mapping with fixed keys.
struct MappingSchema {
  std::string name = {};        // in the reference page and in the table of words for later versions
  std::string definition = {};  // in the JSON Schema, where mappings of one name differ; the name when empty
  std::string documentation = {};
  std::vector<KeySchema> keys = {};
  std::string selector = {};  // the key whose word selects a case; "" without cases
  std::vector<CaseSchema> cases = {};
};

/// The whole format: what a scenario file may hold. Reader, JSON Schema, reference page and messages come from it.
const MappingSchema& scenario_schema();

/// What stands at a place of a list.
const ValueSchema& item_of(const ValueSchema& list, std::size_t index);

/// The key of that name, or nullptr.
const KeySchema* find_key(const std::vector<KeySchema>& keys, std::string_view key);

/// The case of that word, or nullptr.
const CaseSchema* find_case(const MappingSchema& mapping, std::string_view word);

/// "greater than 0 mm", "from 0 to 1", "at least 0 s"; "" when every number is allowed. In the example's unit.
std::string range_text(const Range& range, const std::string& example);

/// What a value must be, for messages: "a length (e.g. 0.8 mm)", "one of `x`, `y`, `z`".
std::string expectation(const ValueSchema& value);

}  // namespace thinwall
