#include "studio/schema/JsonSchema.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "studio/schema/Schema.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

const std::string kParameterPattern = R"(\$\{[A-Za-z_][A-Za-z0-9_-]*\})";
const std::string kNumberPattern = R"([+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?)";
const std::string kNamePattern = "^[A-Za-z_][A-Za-z0-9_-]*$";

Json reference(const std::string& name) {
  return {{"$ref", "#/definitions/" + name}};
}

/// A shared definition to which a description can be given: beside a plain `$ref` it would be ignored.
Json shared(const std::string& name) {
  return {{"allOf", Json::array({reference(name)})}};
}

/// Any value may be a parameter instead.
Json or_parameter(Json value) {
  return {{"anyOf", Json::array({std::move(value), reference("parameter")})}};
}

Json pattern(const std::string& words) {
  return {{"type", "string"}, {"pattern", words}};
}

/// What many keys have in common.
Json shared_definitions() {
  Json number = or_parameter({{"type", "number"}});
  number["anyOf"].push_back(pattern("^" + kNumberPattern + "$"));
  Json quantity = or_parameter(pattern("^" + kNumberPattern + " *[^0-9 ,].*$"));
  quantity["anyOf"].push_back(pattern("^[+-]?0+(\\.0*)?$"));
  quantity["anyOf"].push_back({{"const", 0}});
  const Json direction{{"type", "array"}, {"items", reference("number")}, {"minItems", 3}, {"maxItems", 3}};
  Json definitions;
  definitions["parameter"] = pattern(kParameterPattern);
  definitions["name"] = or_parameter(pattern(kNamePattern));
  definitions["boolean"] = or_parameter({{"type", "boolean"}});
  definitions["axes"] = or_parameter(pattern("^[xyz]{1,3}$"));
  definitions["number"] = number;
  definitions["quantity"] = quantity;
  definitions["direction"] = or_parameter(direction);
  return definitions;
}

class SchemaWriter {
 public:
  /// Without `with_needed` no key is required: the form for files whose included files hold the rest.
  SchemaWriter(bool with_needed, Json& definitions) : with_needed_(with_needed), definitions_(definitions) {}

  /// A reference to the definition of the mappings that may stand in one place, which is written when it is not there.
  Json one_of(const std::vector<MappingSchema>& mappings) {
    std::string name = mappings[0].definition.empty() ? mappings[0].name : mappings[0].definition;
    // A slash would divide the reference to it.
    std::ranges::replace_if(
        name, [](char c) { return c == ' ' || c == '/' || c == '^'; }, '_');
    if (!with_needed_) name += "_in_including_file";
    if (!definitions_.contains(name)) {
      definitions_[name] = nullptr;
      Json alternatives = Json::array();
      for (const MappingSchema& alternative : mappings) alternatives.push_back(mapping(alternative));
      definitions_[name] = mappings.size() == 1 ? alternatives[0] : Json{{"anyOf", alternatives}};
    }
    return shared(name);
  }

 private:
  Json value(const ValueSchema& schema) {
    Json plain = plain_value(schema);
    if (schema.mappings.empty() || schema.kind == ValueKind::kMapping || schema.kind == ValueKind::kNamedMappings) {
      return plain;
    }
    plain["anyOf"].push_back(one_of(schema.mappings));
    return plain;
  }

  Json mapping(const MappingSchema& schema) {
    if (schema.selector.empty()) return object(schema, schema.keys, "");
    Json cases = Json::array();
    for (const CaseSchema& row : schema.cases) {
      std::vector<KeySchema> keys = schema.keys;
      keys.insert(keys.end(), row.keys.begin(), row.keys.end());
      Json part = object(schema, keys, row.word);
      part["description"] = row.documentation;
      cases.push_back(std::move(part));
    }
    // Which keys belong to a word that is a parameter cannot be known here.
    cases.push_back({{"type", "object"},
                     {"properties", {{schema.selector, reference("parameter")}}},
                     {"required", {schema.selector}}});
    return {{"description", schema.documentation}, {"anyOf", cases}};
  }

  Json plain_value(const ValueSchema& schema) {
    switch (schema.kind) {
      case ValueKind::kText:
        return {{"type", {"string", "number", "boolean"}}};
      case ValueKind::kPath:
        return {{"type", "string"}, {"minLength", 1}};
      case ValueKind::kName:
        return shared("name");
      case ValueKind::kWord:
        return or_parameter(words(schema));
      case ValueKind::kBoolean:
        return shared("boolean");
      case ValueKind::kInteger:
      case ValueKind::kQuantity:
        return quantity(schema);
      case ValueKind::kAnyQuantity:
        return any_quantity(schema);
      case ValueKind::kAxes:
        return shared("axes");
      case ValueKind::kDirection:
        return shared("direction");
      case ValueKind::kList:
        return list(schema);
      case ValueKind::kMapping:
        return one_of(schema.mappings);
      case ValueKind::kNamedMappings:
        return named(schema);
      case ValueKind::kChanges:
        return {{"type", "object"}};
      case ValueKind::kParameters:
        break;
    }
    return {{"type", {"object", "null"}},
            {"propertyNames", {{"pattern", kNamePattern}}},
            {"additionalProperties", {{"type", {"string", "number", "boolean", "array"}}}}};
  }

  static Json words(const ValueSchema& schema) {
    Json allowed = schema.words;
    // The word `true` is a boolean to JSON.
    for (const std::string& word : schema.words) {
      if (word == "true") allowed.push_back(true);
    }
    return {{"enum", allowed}};
  }

  static Json number(const ValueSchema& schema) {
    Json result{{"type", schema.kind == ValueKind::kInteger ? "integer" : "number"}};
    const Range& range = schema.range;
    const auto plain = [&](double limit) {
      return schema.kind == ValueKind::kInteger ? Json(static_cast<std::int64_t>(limit)) : Json(limit);
    };
    if (std::isfinite(range.minimum)) {
      result[range.minimum_excluded ? "exclusiveMinimum" : "minimum"] = plain(range.minimum);
    }
    if (std::isfinite(range.maximum)) {
      result[range.maximum_excluded ? "exclusiveMaximum" : "maximum"] = plain(range.maximum);
    }
    if (schema.multiple_of != 1) result["multipleOf"] = schema.multiple_of;
    return result;
  }

  static Json quantity(const ValueSchema& schema) {
    Json result = shared("quantity");
    if (schema.dimension == kDimensionless) {
      result = or_parameter(number(schema));
      result["anyOf"].push_back(pattern("^" + kNumberPattern + "$"));
    } else if (schema.bare_unit || !schema.mappings.empty()) {
      result = {{"anyOf", Json::array({reference("quantity")})}};
      if (schema.bare_unit) result["anyOf"].push_back(pattern("^[^0-9]"));
    }
    std::string words = expectation(schema);
    const std::string range = range_text(schema.range, schema.example);
    if (!range.empty()) words += ", " + range;
    result["description"] = words;
    return result;
  }

  static Json any_quantity(const ValueSchema& schema) {
    return {{"anyOf", Json::array({reference("quantity"), reference("number")})}, {"description", expectation(schema)}};
  }

  Json list(const ValueSchema& schema) {
    Json items = value(schema.item[0]);
    if (schema.item.size() > 1) {
      items = Json::array();
      for (const ValueSchema& item : schema.item) items.push_back(value(item));
    }
    Json result{{"type", {"array", "null"}}, {"items", items}};
    if (schema.minimum_items > 0) {
      result["type"] = "array";
      result["minItems"] = schema.minimum_items;
    }
    if (schema.maximum_items != std::numeric_limits<std::size_t>::max()) result["maxItems"] = schema.maximum_items;
    result = or_parameter(std::move(result));
    if (schema.single) result["anyOf"].push_back(value(schema.item[0]));
    return result;
  }

  Json named(const ValueSchema& schema) {
    Json result{{"type", {"object", "null"}},
                {"propertyNames", {{"pattern", kNamePattern}}},
                {"additionalProperties", one_of(schema.mappings)}};
    if (schema.minimum_items > 0) {
      result["type"] = "object";
      result["minProperties"] = schema.minimum_items;
    }
    return result;
  }

  /// `word`: of the selecting key, "" without one.
  Json object(const MappingSchema& schema, const std::vector<KeySchema>& keys, const std::string& word) {
    Json properties = Json::object();
    Json needed = Json::array();
    for (const KeySchema& key : keys) {
      Json entry = key.key == schema.selector ? Json{{"const", word}} : value(key.value);
      const std::string more = entry.contains("description") ? ": " + entry["description"].get<std::string>() : "";
      entry["description"] = key.documentation + more;
      if (key.fallback && *key.fallback != "{}" && *key.fallback != "[]") entry["default"] = *key.fallback;
      properties[key.key] = std::move(entry);
      // The word must be there to tell the case when it has no default, or another than this one.
      const bool selects = key.key == schema.selector && key.fallback != word;
      if (selects || (with_needed_ && key.needed)) needed.push_back(key.key);
    }
    Json result{{"description", schema.documentation}, {"type", "object"}, {"properties", properties}};
    if (needed.empty()) result["type"] = {"object", "null"};
    if (!needed.empty()) result["required"] = needed;
    result["additionalProperties"] = false;
    return result;
  }

  bool with_needed_;
  Json& definitions_;
};

}  // namespace

std::string scenario_json_schema() {
  Json definitions = shared_definitions();
  const Json whole = SchemaWriter(true, definitions).one_of({scenario_schema()});
  const Json including = SchemaWriter(false, definitions).one_of({scenario_schema()});
  const Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                    {"title", "Thinwall scenario, version 1"},
                    {"type", "object"},
                    {"if", {{"required", {"include"}}}},
                    {"then", including},
                    {"else", whole},
                    {"definitions", definitions}};
  return schema.dump(1) + "\n";
}

}  // namespace thinwall
