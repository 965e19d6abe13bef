#include "studio/scenario/UnitPass.hpp"

#include <algorithm>

#include "studio/scenario/ValueReader.hpp"
#include "studio/scenario/YamlReader.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// The keys that a mapping may have, after its case is known.
struct AllowedKeys {
  std::vector<const KeySchema*> keys;
  std::string words_of_case;            // "`kind: point`", "" without cases
  std::vector<std::string> misspelled;  // keys that a misspelled one was taken for
  bool case_is_known = true;            // false after a wrong word: then the keys of all cases are let through unread
};

class SchemaReader {
 public:
  explicit SchemaReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  CheckedValue read_mapping(const MappingSchema& schema, const TextNode& node, const ValuePlace& place) {
    CheckedValue result{.kind = CheckedKind::kMapping, .location = error_location(node, place)};
    AllowedKeys allowed = allowed_keys(schema, node);
    for (const TextMember& member : node.members) check_key(schema, allowed, node, member, place);
    for (const KeySchema* key : allowed.keys) {
      const bool is_misspelled = std::ranges::find(allowed.misspelled, key->key) != allowed.misspelled.end();
      if (!is_misspelled) read_key(*key, schema, node, place, result);
      if (is_misspelled) result.wrong_keys.push_back(key->key);
    }
    return result;
  }

 private:
  std::optional<CheckedValue> read(const ValueSchema& schema, const TextNode& node, const ValuePlace& place) {
    if (node.told) return std::nullopt;
    switch (schema.kind) {
      case ValueKind::kList:
        return read_list(schema, node, place);
      case ValueKind::kMapping:
        return read_one_of(schema, node, place);
      case ValueKind::kNamedMappings:
        return read_named(schema, node, place);
      case ValueKind::kParameters:
      case ValueKind::kChanges:
        return as_text(node);
      default:
        break;
    }
    if (node.kind == NodeKind::kMapping && !schema.mappings.empty()) return read_field(schema, node, place);
    return read_plain_value(schema, node, place, diagnostics_);
  }

  /// A mapping in place of a quantity; it keeps what the quantity must be.
  std::optional<CheckedValue> read_field(const ValueSchema& schema, const TextNode& node, const ValuePlace& place) {
    std::optional<CheckedValue> value = read_one_of(schema, node, place);
    if (value) {
      value->range = schema.range;
      value->example = schema.example;
    }
    return value;
  }

  // Lists.

  static bool are_numbers(const TextNode& list) {
    return std::ranges::all_of(list.items, [](const TextNode& item) {
      return item.text.find_first_of("0123456789") <= 1;  // behind a sign
    });
  }

  std::optional<CheckedValue> read_list(const ValueSchema& schema, const TextNode& node, const ValuePlace& place) {
    const bool is_single = schema.single && node.kind == NodeKind::kText;
    if (node.kind != NodeKind::kList && node.kind != NodeKind::kEmpty && !is_single) {
      const bool is_mapping = node.kind == NodeKind::kMapping;
      refuse(node, place, expectation(schema),
             describe(node) +
                 (is_mapping ? ": each item of a list begins with `- `, or all stand within `[` and `]`" : ""),
             diagnostics_);
      return std::nullopt;
    }
    const std::size_t count = is_single ? 1 : node.items.size();
    if (count < schema.minimum_items || count > schema.maximum_items) {
      std::string got = node.kind == NodeKind::kEmpty ? "nothing" : "a list of " + std::to_string(count);
      if (count > schema.maximum_items && are_numbers(node)) got += ": commas part items, decimals take a point";
      refuse(node, place, expectation(schema), got, diagnostics_);
      return std::nullopt;
    }
    CheckedValue result{.kind = CheckedKind::kList, .location = error_location(node, place)};
    for (std::size_t index = 0; index < count; ++index) {
      const TextNode& item = is_single ? node : node.items[index];
      const ValuePlace item_place{item_path(place.path, index), place.owner, place.key, item.location};
      std::optional<CheckedValue> value = read(item_of(schema, index), item, item_place);
      // A wrong item stays as an empty mapping, so that later passes count items as the file does.
      if (!value && item_of(schema, index).kind == ValueKind::kMapping) value = CheckedValue{.location = item.location};
      if (value) result.items.push_back(std::move(*value));
    }
    const bool has_fixed_size = schema.minimum_items == schema.maximum_items;
    if (has_fixed_size && result.items.size() != count) return std::nullopt;
    return result;
  }

  // Mappings.

  static std::string names_advice(const TextNode& node) {
    if (node.kind == NodeKind::kList) return ": names stand without `- ` and end in `:`";
    const bool has_colon = node.kind == NodeKind::kText && node.text.find(':') != std::string::npos;
    return has_colon ? ": a key is followed by `:` and a space" : "";
  }

  /// The "depth" of `{ depth:6 mm }`, where that is one of the words; else "".
  static std::string word_without_space(const std::string& key, const std::vector<std::string>& words) {
    const std::string word = key.substr(0, std::min(key.find(':'), key.size()));
    return word.size() < key.size() && std::ranges::find(words, word) != words.end() ? word : "";
  }

  std::optional<CheckedValue> read_one_of(const ValueSchema& schema, const TextNode& node, const ValuePlace& place) {
    if (node.kind != NodeKind::kMapping && node.kind != NodeKind::kEmpty) {
      refuse(node, place, expectation(schema), describe(node) + names_advice(node), diagnostics_);
      return std::nullopt;
    }
    if (schema.mappings.size() == 1) return read_mapping(schema.mappings[0], node, place);
    const MappingSchema* chosen = nullptr;
    for (const MappingSchema& mapping : schema.mappings) {
      const TextMember* member = node.find(mapping.keys[0].key);
      if (member == nullptr) continue;
      if (chosen != nullptr) {
        diagnostics_.error(
            member->location, place.path,
            in_backticks(chosen->keys[0].key) + " and " + in_backticks(member->key) + " exclude each other");
        return std::nullopt;
      }
      chosen = &mapping;
    }
    if (chosen != nullptr) return read_mapping(*chosen, node, place);
    refuse_all_keys(schema, node, place);
    return std::nullopt;
  }

  static std::string needs_space(const std::string& word) {
    return ", a space is needed behind " + in_backticks(word + ":");
  }

  static bool is_key_of_any(const ValueSchema& schema, const std::string& word) {
    return std::ranges::any_of(schema.mappings, [&](const MappingSchema& mapping) {
      return std::ranges::any_of(mapping.keys, [&](const KeySchema& key) { return key.key == word; });
    });
  }

  /// None of the keys that tell the alternatives apart is there.
  void refuse_all_keys(const ValueSchema& schema, const TextNode& node, const ValuePlace& place) {
    std::vector<std::string> words;
    for (const MappingSchema& mapping : schema.mappings) words.push_back(mapping.keys[0].key);
    for (const TextMember& member : node.members) {
      // A key that an alternative does have is no mistake: what tells the alternatives apart is missing.
      if (is_key_of_any(schema, member.key)) continue;
      const std::string unspaced = word_without_space(member.key, words);
      const std::string nearest = unspaced.empty() ? did_you_mean(member.key, words) : needs_space(unspaced);
      if (nearest.empty() && node.members.size() > 1) continue;
      diagnostics_.error(member.location, member_path(place.path, member.key),
                         "unknown key" + (nearest.empty() ? "; allowed: " + list_in_backticks(words) : nearest));
      return;
    }
    diagnostics_.absence(place.location, place.path, "one of " + list_in_backticks(words) + " is missing");
  }

  std::optional<CheckedValue> read_named(const ValueSchema& schema, const TextNode& node, const ValuePlace& place) {
    if (node.kind != NodeKind::kMapping && node.kind != NodeKind::kEmpty) {
      refuse(node, place, "a mapping from names", describe(node) + names_advice(node), diagnostics_);
      return std::nullopt;
    }
    if (node.members.size() < schema.minimum_items) {
      diagnostics_.error(place.location, place.path, "needs at least one " + schema.mappings[0].name);
    }
    CheckedValue result{.kind = CheckedKind::kMapping, .location = error_location(node, place)};
    for (const TextMember& member : node.members) {
      const ValuePlace inner{member_path(place.path, member.key), place.owner, place.key, member.location};
      if (!is_name(member.key)) diagnostics_.error(member.location, inner.path, name_mistake(member.key));
      const ValueSchema mapping{.kind = ValueKind::kMapping, .mappings = {schema.mappings[0]}};
      std::optional<CheckedValue> value = read_one_of(mapping, member.value, inner);
      // A name is known even when it or what it stands for is wrong: other mistakes are told, not consequences.
      if (!value) value = CheckedValue{.kind = CheckedKind::kMapping, .location = member.location};
      result.members.push_back({member.key, member.location, std::move(*value)});
    }
    return result;
  }

  /// Parameters are not read any more when the texts are: they only go into the resolved scenario.
  static CheckedValue as_text(const TextNode& node) {
    CheckedValue value{.kind = CheckedKind::kText, .location = node.location, .text = node.text};
    if (node.kind == NodeKind::kList) value.kind = CheckedKind::kList;
    if (node.kind == NodeKind::kMapping || node.kind == NodeKind::kEmpty) value.kind = CheckedKind::kMapping;
    for (const TextNode& item : node.items) value.items.push_back(as_text(item));
    for (const TextMember& member : node.members) {
      value.members.push_back({member.key, member.location, as_text(member.value)});
    }
    return value;
  }

  // Keys.

  /// The word that selects the case: as given, or the default. Empty when it is missing or wrong.
  static std::string selected_word(const MappingSchema& schema, const TextNode& node) {
    const TextMember* member = node.find(schema.selector);
    if (member != nullptr) return member->value.kind == NodeKind::kText ? member->value.text : "";
    return find_key(schema.keys, schema.selector)->fallback.value_or("");
  }

  static AllowedKeys allowed_keys(const MappingSchema& schema, const TextNode& node) {
    AllowedKeys allowed;
    for (const KeySchema& key : schema.keys) allowed.keys.push_back(&key);
    if (schema.selector.empty()) return allowed;
    const std::string word = selected_word(schema, node);
    const CaseSchema* chosen = find_case(schema, word);
    allowed.case_is_known = chosen != nullptr;
    if (chosen == nullptr) return allowed;
    allowed.words_of_case = in_backticks(schema.selector + ": " + word);
    for (const KeySchema& key : chosen->keys) allowed.keys.push_back(&key);
    return allowed;
  }

  /// The "5 mm" of `{ depth: 6,5 mm }`.
  static bool is_after_decimal_comma(const TextNode& node, const TextMember& member) {
    const bool is_first = &member == &node.members.front();
    return !is_first && member.value.kind == NodeKind::kEmpty && member.key.find_first_of("0123456789") == 0;
  }

  void check_key(const MappingSchema& schema, AllowedKeys& allowed, const TextNode& node, const TextMember& member,
                 const ValuePlace& place) {
    const auto is_it = [&](const KeySchema* key) { return key->key == member.key; };
    if (std::ranges::any_of(allowed.keys, is_it)) return;
    const std::string path = member_path(place.path, member.key);
    if (allowed.case_is_known) {
      // After a wrong word, which is told already, the keys that belong to the right one are not known.
      const std::string unspaced = word_without_space(member.key, words_of(allowed));
      const std::string nearest = unspaced.empty() ? nearest_word(member.key, words_of(allowed)) : unspaced;
      const bool is_decimals = is_after_decimal_comma(node, member);
      diagnostics_.error(member.location, path,
                         "unknown key" + (is_decimals        ? ": commas part keys, decimals take a point"
                                          : unspaced.empty() ? hint(schema, allowed, member.key, nearest)
                                                             : needs_space(unspaced)));
      if (!nearest.empty() && node.find(nearest) == nullptr) allowed.misspelled.push_back(nearest);
    }
  }

  static std::vector<std::string> words_of(const AllowedKeys& allowed) {
    std::vector<std::string> words;
    for (const KeySchema* key : allowed.keys) words.push_back(key->key);
    return words;
  }

  /// What the user may have meant by an unknown key.
  static std::string hint(const MappingSchema& schema, const AllowedKeys& allowed, const std::string& key,
                          const std::string& nearest) {
    std::string cases;
    for (const CaseSchema& row : schema.cases) {
      if (find_key(row.keys, key) != nullptr) cases += (cases.empty() ? "" : ", ") + in_backticks(row.word);
    }
    if (!cases.empty()) return " for " + allowed.words_of_case + ", it belongs to " + cases;
    if (!nearest.empty()) return ", did you mean " + in_backticks(nearest) + "?";
    for (const KeySchema* known : allowed.keys) {
      for (const MappingSchema& inner : known->value.mappings) {
        const bool is_inside = known->value.kind == ValueKind::kMapping && find_key(inner.keys, key) != nullptr;
        if (is_inside) return ", it belongs inside " + in_backticks(known->key);
      }
    }
    return "; allowed: " + list_in_backticks(words_of(allowed));
  }

  void read_key(const KeySchema& key, const MappingSchema& schema, const TextNode& node, const ValuePlace& place,
                CheckedValue& result) {
    const std::string path = member_path(place.path, key.key);
    if (const TextMember* member = node.find(key.key)) {
      const ValuePlace inner{path, schema.name, key.key, member->location};
      std::optional<CheckedValue> value = read(key.value, member->value, inner);
      if (value) {
        result.members.push_back({key.key, member->location, std::move(*value)});
      } else {
        result.wrong_keys.push_back(key.key);
      }
    } else if (key.needed) {
      diagnostics_.absence(place.location, place.path,
                           in_backticks(key.key) + " is missing: " + key.documentation + ", " + expectation(key.value));
    } else if (key.fallback) {
      result.members.push_back(
          {key.key, place.location, read_fallback(key, {path, schema.name, key.key, place.location})});
    }
  }

  CheckedValue read_fallback(const KeySchema& key, const ValuePlace& place) {
    std::optional<TextNode> node = read_yaml_text(*key.fallback, place.location.file, diagnostics_);
    std::optional<CheckedValue> value = node ? read(key.value, *node, place) : std::nullopt;
    if (!value) throw std::logic_error("the schema's default of " + place.path + " is not what it asks for");
    mark_as_default(*value, place.location);
    return std::move(*value);
  }

  static void mark_as_default(CheckedValue& value, const SourceLocation& location) {
    value.given = false;
    value.location = location;
    for (CheckedValue& item : value.items) mark_as_default(item, location);
    for (CheckedMember& member : value.members) {
      member.location = location;
      mark_as_default(member.value, location);
    }
  }

  Diagnostics& diagnostics_;
};

}  // namespace

CheckedValue unit_pass(const TextNode& root, const MappingSchema& schema, Diagnostics& diagnostics) {
  const ValuePlace place{"", schema.name, "", {root.location.file, 1, 1}};
  return SchemaReader(diagnostics).read_mapping(schema, root, place);
}

}  // namespace thinwall
