#include "studio/scenario/ValueReader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// Bytes; a take keeps titles where it has room for 64 kB.
constexpr std::size_t kLongestText = 10000;

std::string trimmed(std::string text) {
  const auto is_space = [](char character) { return character == ' ' || character == '\n' || character == '\t'; };
  while (!text.empty() && is_space(text.back())) text.pop_back();
  text.erase(text.begin(), std::ranges::find_if_not(text, is_space));
  return text;
}

bool is_number(const std::string& text) {
  try {
    return !text.ends_with('%') && parse_quantity(text).dimension == kDimensionless;
  } catch (const QuantityError&) {
    return false;
  }
}

/// Reads plain values and tells what is wrong with them.
class PlainReader {
 public:
  PlainReader(const ValueSchema& schema, const TextNode& node, const ValuePlace& place, Diagnostics& diagnostics)
      : schema_(schema), node_(node), place_(place), diagnostics_(diagnostics) {}

  std::optional<CheckedValue> read() {
    if (node_.told) return std::nullopt;
    if (schema_.kind == ValueKind::kDirection) return read_direction();
    if (node_.kind != NodeKind::kText) return refuse_value(describe(node_));
    text_ = trimmed(node_.text);
    switch (schema_.kind) {
      case ValueKind::kText:
        return read_text();
      case ValueKind::kPath:
        return read_path();
      case ValueKind::kWord:
        return read_word();
      case ValueKind::kName:
        return is_name(text_) ? std::optional(text_value())
                              : refuse_value(describe(node_) + "; " + name_mistake(text_));
      case ValueKind::kBoolean:
        return read_boolean();
      case ValueKind::kInteger:
      case ValueKind::kQuantity:
      case ValueKind::kAnyQuantity:
        return read_quantity();
      case ValueKind::kAxes:
        return read_axes();
      default:
        return std::nullopt;
    }
  }

 private:
  CheckedValue value_of(CheckedKind kind) const { return {.kind = kind, .location = node_.location}; }

  CheckedValue text_value() const {
    CheckedValue value = value_of(CheckedKind::kText);
    value.text = text_;
    return value;
  }

  std::optional<CheckedValue> read_text() {
    if (text_.empty()) return refuse_value("an empty text");
    if (text_.size() > kLongestText) {
      return refuse_value("one of " + std::to_string(text_.size()) + " bytes; a text has at most " +
                          std::to_string(kLongestText));
    }
    if (!node_.cut_off.empty()) {
      diagnostics_.warning(node_.location, place_.path,
                           in_backticks(node_.cut_off) + " is taken for a comment, so that the text is " +
                               in_backticks(text_) + "; a text with ` #` in it needs quotation marks around it");
    }
    return text_value();
  }

  /// A quantity as the user wrote it, on one line.
  std::string unquoted_text() const {
    const std::string words = in_backticks(text_);
    return words.substr(1, words.size() - 2);
  }

  std::optional<CheckedValue> refuse_value(const std::string& got) {
    refuse(node_, place_, expectation(schema_), got, diagnostics_);
    return std::nullopt;
  }

  std::string origin() const { return node_.parameters.empty() ? "" : " (" + node_.parameters + ")"; }

  std::optional<CheckedValue> error(const std::string& message) {
    diagnostics_.error(error_location(node_, place_), place_.path, message + origin());
    return std::nullopt;
  }

  std::optional<CheckedValue> read_path() {
    if (text_.empty()) return refuse_value("an empty text");
    CheckedValue value = value_of(CheckedKind::kPath);
    value.text = (node_.location.file.parent_path() / text_).lexically_normal().string();
    return value;
  }

  std::optional<CheckedValue> read_word() {
    if (std::ranges::find(schema_.words, text_) != schema_.words.end()) return text_value();
    const std::string nearest = did_you_mean(text_, schema_.words);
    return error("expected " + expectation(schema_) + ", got " + describe(node_) + nearest);
  }

  std::optional<CheckedValue> read_boolean() {
    if (text_ != "true" && text_ != "false") return refuse_value(describe(node_));
    CheckedValue value = value_of(CheckedKind::kBoolean);
    value.boolean = text_ == "true";
    return value;
  }

  std::optional<CheckedValue> read_axes() {
    std::string axes;
    for (const char axis : {'x', 'y', 'z'}) {
      const auto times = std::ranges::count(text_, axis);
      if (times > 1) return refuse_value(describe(node_));
      if (times == 1) axes += axis;
    }
    if (axes.empty() || axes.size() != text_.size()) return refuse_value(describe(node_));
    CheckedValue value = value_of(CheckedKind::kText);
    value.text = axes;
    return value;
  }

  std::optional<CheckedValue> read_quantity() {
    Quantity quantity;
    try {
      const bool is_bare_unit = schema_.bare_unit && !text_.empty() && text_.find_first_of("0123456789") != 0 &&
                                text_.front() != '-' && text_.front() != '+' && text_.front() != '.';
      quantity = is_bare_unit ? parse_unit(text_) : parse_quantity(text_);
    } catch (const QuantityError& reason) {
      return error("expected " + expectation(schema_) + ", got " + describe(node_) + ": " + reason.what());
    }
    if (schema_.kind == ValueKind::kAnyQuantity) {
      CheckedValue value = value_of(CheckedKind::kNumber);
      value.number = quantity.value == 0 ? 0 : quantity.value;
      value.dimension = quantity.dimension;
      return value;
    }
    const bool is_bare = quantity.dimension == kDimensionless && is_number(text_);
    const bool is_zero_without_unit = is_bare && quantity.value == 0;
    if (quantity.dimension != schema_.dimension && !is_zero_without_unit) {
      const std::string got =
          unquoted_text() + (is_bare ? " without a unit" : ", " + dimension_name(quantity.dimension));
      return refuse_value(got);
    }
    return check_number(quantity.value);
  }

  std::optional<CheckedValue> check_number(double number) {
    const bool is_integer = schema_.kind == ValueKind::kInteger;
    if (is_integer && std::floor(number) != number) return refuse_value(describe(node_));
    const Range& range = schema_.range;
    if (!holds(range, number)) {
      return error(unquoted_text() + " is out of range, it must be " + range_text(range, schema_.example));
    }
    if (is_integer && std::fmod(number, schema_.multiple_of) != 0) {
      return error(unquoted_text() + " is not a multiple of " + std::to_string(schema_.multiple_of));
    }
    if (schema_.usual != nullptr && !is_usual(*schema_.usual, number)) doubt_number(*schema_.usual);
    CheckedValue value = value_of(is_integer ? CheckedKind::kInteger : CheckedKind::kNumber);
    // A negative zero would show in the resolved scenario.
    value.number = number == 0 ? 0 : number;
    return value;
  }

  void doubt_number(const UsualRange& usual) {
    diagnostics_.warning(error_location(node_, place_), place_.path,
                         unquoted_text() + " is unusual: " + std::string(usual.what) + " are " +
                             range_text(usual.magnitudes, std::string(usual.example)) +
                             " as a rule; see whether number and unit are meant so" + origin());
  }

  std::optional<CheckedValue> read_direction() {
    if (node_.kind != NodeKind::kList || node_.items.size() != 3) {
      const bool is_list = node_.kind == NodeKind::kList;
      return refuse_value(is_list ? "a list of " + std::to_string(node_.items.size()) : describe(node_));
    }
    const ValueSchema component{.kind = ValueKind::kQuantity, .example = "0.5"};
    CheckedValue value = value_of(CheckedKind::kList);
    for (std::size_t index = 0; index < 3; ++index) {
      const ValuePlace place{item_path(place_.path, index), place_.owner, place_.key, node_.items[index].location};
      std::optional<CheckedValue> number = read_plain_value(component, node_.items[index], place, diagnostics_);
      if (number) value.items.push_back(std::move(*number));
    }
    if (value.items.size() != 3) return std::nullopt;
    return normalized(std::move(value));
  }

  std::optional<CheckedValue> normalized(CheckedValue value) {
    double largest = 0;
    for (const CheckedValue& item : value.items) largest = std::max(largest, std::abs(item.number));
    if (largest == 0) return error("the direction [0, 0, 0] points nowhere; at least one number must not be 0");
    // Scaling first keeps the squares of very large and very small numbers in range.
    double length = 0;
    for (CheckedValue& item : value.items) {
      item.number /= largest;
      length = std::hypot(length, item.number);
    }
    for (CheckedValue& item : value.items) item.number /= length;
    return value;
  }

  const ValueSchema& schema_;
  const TextNode& node_;
  const ValuePlace& place_;
  Diagnostics& diagnostics_;
  std::string text_;
};

}  // namespace

SourceLocation error_location(const TextNode& node, const ValuePlace& place) {
  return node.kind == NodeKind::kEmpty ? place.location : node.location;
}

void refuse(const TextNode& node, const ValuePlace& place, const std::string& expected, const std::string& got,
            Diagnostics& diagnostics) {
  const std::string origin = node.parameters.empty() ? "" : " (" + node.parameters + ")";
  diagnostics.error(error_location(node, place), place.path, "expected " + expected + ", got " + got + origin);
}

std::optional<CheckedValue> read_plain_value(const ValueSchema& schema, const TextNode& node, const ValuePlace& place,
                                             Diagnostics& diagnostics) {
  return PlainReader(schema, node, place, diagnostics).read();
}

}  // namespace thinwall
