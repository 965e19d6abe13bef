#pragma once

#include <optional>
#include <string>

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"
#include "studio/scenario/TextNode.hpp"
#include "studio/schema/Schema.hpp"

namespace thinwall {

/// Where a value stands: what messages begin with.
struct ValuePlace {
  std::string path = {};         // "bodies.organ.wall.thickness"
  std::string owner = {};        // the name of the mapping that has the key: "wall"
  std::string key = {};          // "thickness"
  SourceLocation location = {};  // of the key, or of the list's item
};

/// The place of an error in a value: its own, or that of its key when nothing stands there.
SourceLocation error_location(const TextNode& node, const ValuePlace& place);

/// Tells that the value is not what the schema wants: "expected a length (e.g. 0.8 mm), got a list".
void refuse(const TextNode& node, const ValuePlace& place, const std::string& expected, const std::string& got,
            Diagnostics& diagnostics);

/// Reads a text, word, name, path, number or direction: every kind but lists and mappings. Empty after an error.
std::optional<CheckedValue> read_plain_value(const ValueSchema& schema, const TextNode& node, const ValuePlace& place,
                                             Diagnostics& diagnostics);

}  // namespace thinwall
