#include "studio/schema/ReferencePage.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "studio/schema/ExpectationQuantity.hpp"
#include "studio/schema/Schema.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

constexpr std::string_view kRules = R"(# The scenario format, version 1

A scenario is a YAML file. This page and `scenario.schema.json` come from the table that the program reads scenarios with;
`scripts/format-reference` writes them anew. Editors that know YAML help with keys when the file begins with
`# yaml-language-server: $schema=scenario.schema.json`.

## Rules

- Quantities carry units: `0.8 mm`, `12 kPa`, `30 deg`, `kg*m/s^2`. A bare number stands only where a quantity has no
  dimension, and for zero. Each `/` divides by the one factor after it.
- Three lengths are a point: `[0, 0, 20 mm]`. Three numbers are a direction; its length does not matter.
- Unknown, duplicate and unused keys, wrong units, values out of range and names of nothing are errors, told all at once as
  `file:line:column: error: path: message`. Lines, columns and the items of a list count from 1.
- `parameters` have defaults. `${name}` stands for one in any value: alone for a text or a list, or inside a longer text.
  Write quotation marks around it inside braces: `{ depth: "${depth}" }`. `--set name=value` overrides a default. A
  parameter or an override that nothing uses is an error.
- A text with `: ` or ` #` in it needs quotation marks: `title: "Balloon #1"`.
- `include` names files whose keys are merged below those of the file that includes them. Mappings are merged key by
  key; of anything else, lists too, the nearest wins: the including file over the included, a later one over an earlier.
  A mapping of another kind (another law, shape, tool, fluid) replaces the farther one as a whole.
- Paths are relative to the file that names them.
- `true` and `false` are the only booleans. YAML tags and merge keys (`<<`) are not allowed; anchors and aliases are.
- A file has at most 1 MiB, 100 000 values and 64 levels, a text 10 000 bytes.

## Units

)";

constexpr std::array kDimensionsOfTheFormat = {kLength,   kTime,    kSpeed, kAcceleration,
                                               kPressure, kDensity, kAngle, kAngularSpeed};

constexpr std::string_view kUnitsText = R"(
Units: `m`, `g`, `s`, `N`, `Pa`, `J`, `W`, `Hz`, `l`, `bar`, `rad` with the prefixes `n`, `u`, `m`, `c`, `d`, `k`, and but for
`m`, `s`, `l`, `bar`, `rad` also `M`, `G`; and `min`, `h`, `deg`, `mmHg`, `cmH2O`, `%`. Powers are written `m^2` or `m²`, products
`kg*m/s^2`.

)";

/// Text for a cell of a table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

std::string capitalized(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string anchor(std::string heading) {
  std::ranges::replace(heading, ' ', '-');
  return heading;
}

class PageWriter {
 public:
  std::string write() {
    page_ << kRules << "| Dimension | Example |\n| --- | --- |\n";
    for (const Dimension& dimension : kDimensionsOfTheFormat) {
      page_ << "| " << dimension_name(dimension) << " | `" << dimension_example(dimension) << "` |\n";
    }
    page_ << kUnitsText;
    write_usual_ranges();
    page_ << "## Keys\n\n";
    write_alternatives({scenario_schema()});
    write_measured_quantities();
    return page_.str();
  }

 private:
  static std::string link(const MappingSchema& schema) { return "[" + schema.name + "](#" + anchor(schema.name) + ")"; }

  static std::string value_words(const ValueSchema& value) {
    if (!value.page_words.empty()) return value.page_words;
    const bool is_mapping = value.kind == ValueKind::kMapping;
    if (is_mapping) return link(value.mappings[0]);
    if (value.kind == ValueKind::kNamedMappings) return "names, each with a " + link(value.mappings[0]);
    if (value.kind == ValueKind::kParameters) return "names with texts or lists";
    if (value.kind == ValueKind::kChanges) return "names or paths with new values";
    if (value.kind == ValueKind::kList && value.item[0].kind == ValueKind::kMapping) {
      return "a list of " + link(value.item[0].mappings[0]);
    }
    std::string words = expectation(value);
    if (value.kind == ValueKind::kList) words += list_range(value);
    const std::string range = range_text(value.range, value.example);
    if (!range.empty()) words += ", " + range;
    if (!value.mappings.empty()) words += "; or " + link(value.mappings[0]);
    return words;
  }

  static std::string list_range(const ValueSchema& list) {
    const ValueSchema& item = list.item[0];
    const std::string range = range_text(item.range, item.example);
    return range.empty() ? "" : ", each " + range;
  }

  static std::string default_words(const KeySchema& key) {
    if (key.needed) return "needed";
    if (!key.fallback || *key.fallback == "{}" || *key.fallback == "[]") return "";
    return in_backticks(*key.fallback);
  }

  void write_table(const std::vector<KeySchema>& keys) {
    page_ << "| Key | Value | Default | Meaning |\n| --- | --- | --- | --- |\n";
    for (const KeySchema& key : keys) {
      page_ << "| `" << key.key << "` | " << cell(value_words(key.value)) << " | " << default_words(key) << " | "
            << cell(key.documentation) << " |\n";
    }
    page_ << "\n";
  }

  /// The mappings that may stand in one place share a name and a heading.
  void write_alternatives(const std::vector<MappingSchema>& mappings) {
    if (!written_.insert(mappings[0].name).second) return;
    page_ << "### " << mappings[0].name << "\n\n";
    if (mappings.size() > 1) page_ << "One of the following.\n\n";
    const bool have_one_key_each =
        std::ranges::all_of(mappings, [](const MappingSchema& mapping) { return mapping.keys.size() == 1; });
    if (mappings.size() > 1 && have_one_key_each) {
      std::vector<KeySchema> keys;
      for (const MappingSchema& mapping : mappings) keys.push_back(mapping.keys[0]);
      for (KeySchema& key : keys) key.needed = false;
      write_table(keys);
    } else {
      for (const MappingSchema& mapping : mappings) write_mapping(mapping);
    }
    for (const MappingSchema& mapping : mappings) write_inner(mapping);
  }

  void write_mapping(const MappingSchema& mapping) {
    page_ << capitalized(mapping.documentation) << "\n\n";
    write_table(mapping.keys);
    for (const CaseSchema& row : mapping.cases) {
      page_ << "With `" << mapping.selector << ": " << row.word << "`: " << row.documentation
            << (row.keys.empty() ? "; no further keys.\n\n" : ".\n\n");
      if (!row.keys.empty()) write_table(row.keys);
    }
  }

  void write_inner(const MappingSchema& mapping) {
    write_inner(mapping.keys);
    for (const CaseSchema& row : mapping.cases) write_inner(row.keys);
  }

  void write_inner(const std::vector<KeySchema>& keys) {
    for (const KeySchema& key : keys) {
      if (!key.value.page_words.empty()) continue;
      const ValueSchema& value = key.value.kind == ValueKind::kList ? key.value.item[0] : key.value;
      if (!value.mappings.empty()) write_alternatives(value.mappings);
    }
  }

  void write_usual_ranges() {
    page_ << "## What is usual\n\nBeyond these magnitudes a warning asks whether number and unit are meant so; nothing "
             "else comes of it.\n\n| What | Usually |\n| --- | --- |\n";
    for (const UsualRange* usual : kUsualRanges) {
      page_ << "| " << usual->what << " | " << range_text(usual->magnitudes, std::string(usual->example)) << " |\n";
    }
    page_ << "\n";
  }

  void write_measured_quantities() {
    page_ << "## What can be expected\n\nThe words of `quantity` in an [expectation](#expectation), what each is "
             "measured of and what it is.\n\n|";
    for (const ReductionWord& reduction : reduction_words())
      page_ << " " << capitalized(std::string(reduction.documentation)) << " |";
    page_ << " Of a | What |\n|";
    for (std::size_t column = 0; column < reduction_words().size() + 2; ++column) page_ << " --- |";
    page_ << "\n";
    for (const MeasuredQuantity& measured : measured_quantities()) {
      page_ << "|";
      for (const ReductionWord& reduction : reduction_words()) {
        page_ << " `" << reduction.prefix << measured.name << "` |";
      }
      page_ << " `" << subject_word(measured.subject) << "` | " << dimension_name(measured.dimension) << ": "
            << measured.documentation << " |\n";
    }
    page_ << "\n";
  }

  std::ostringstream page_;
  std::set<std::string> written_;
};

}  // namespace

std::string scenario_reference() {
  return PageWriter().write();
}

}  // namespace thinwall
