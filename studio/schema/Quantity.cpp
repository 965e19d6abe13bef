#include "studio/schema/Quantity.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <utility>

#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// A unit as coefficient x 10^power_of_ten SI units. Keeping the power apart lets it join the decimal text.
struct Unit {
  double coefficient = 1;
  int power_of_ten = 0;
  Dimension dimension;
};

/// Which prefixes stand before a unit. A million metres, seconds or litres is a slip of the shift key: `20 Mm` for
/// `20 mm`.
enum class Prefixes { kNone, kUpToKilo, kAll };

struct NamedUnit {
  std::string_view symbol;
  Unit unit;
  Prefixes prefixes;
};

constexpr double kDegree = std::numbers::pi / 180;

constexpr std::array kUnits = {
    NamedUnit{"%", {1, -2, kDimensionless}, Prefixes::kNone},
    NamedUnit{"m", {1, 0, kLength}, Prefixes::kUpToKilo},
    NamedUnit{"g", {1, -3, {.mass = 1}}, Prefixes::kAll},
    NamedUnit{"s", {1, 0, kTime}, Prefixes::kUpToKilo},
    NamedUnit{"min", {60, 0, kTime}, Prefixes::kNone},
    NamedUnit{"h", {3600, 0, kTime}, Prefixes::kNone},
    NamedUnit{"rad", {1, 0, kAngle}, Prefixes::kUpToKilo},
    NamedUnit{"deg", {kDegree, 0, kAngle}, Prefixes::kNone},
    NamedUnit{"°", {kDegree, 0, kAngle}, Prefixes::kNone},
    NamedUnit{"N", {1, 0, {.length = 1, .mass = 1, .time = -2}}, Prefixes::kAll},
    NamedUnit{"Pa", {1, 0, kPressure}, Prefixes::kAll},
    NamedUnit{"bar", {1, 5, kPressure}, Prefixes::kUpToKilo},
    NamedUnit{"mmHg", {133.322, 0, kPressure}, Prefixes::kNone},
    NamedUnit{"cmH2O", {98.0665, 0, kPressure}, Prefixes::kNone},
    NamedUnit{"J", {1, 0, {.length = 2, .mass = 1, .time = -2}}, Prefixes::kAll},
    NamedUnit{"W", {1, 0, {.length = 2, .mass = 1, .time = -3}}, Prefixes::kAll},
    NamedUnit{"Hz", {1, 0, {.time = -1}}, Prefixes::kAll},
    NamedUnit{"l", {1, -3, {.length = 3}}, Prefixes::kUpToKilo},
    NamedUnit{"L", {1, -3, {.length = 3}}, Prefixes::kUpToKilo},
};

struct Prefix {
  std::string_view symbol;
  int power_of_ten;
};
constexpr int kKilo = 3;
constexpr std::array kPrefixes = {
    Prefix{"n", -9}, Prefix{"u", -6}, Prefix{"µ", -6}, Prefix{"μ", -6}, Prefix{"m", -3},
    Prefix{"c", -2}, Prefix{"d", -1}, Prefix{"k", 3},  Prefix{"M", 6},  Prefix{"G", 9},
};

struct DimensionWords {
  Dimension dimension;
  std::string_view name;
  std::string_view example;
  std::string_view si;
};
constexpr std::array kDimensions = {
    DimensionWords{kDimensionless, "a plain number", "0.5", ""},
    DimensionWords{kLength, "a length", "0.8 mm", "m"},
    DimensionWords{kArea, "an area", "4 mm^2", "m^2"},
    DimensionWords{kVolume, "a volume", "5 ml", "m^3"},
    DimensionWords{{.mass = 1}, "a mass", "20 g", "kg"},
    DimensionWords{kTime, "a time", "1.5 s", "s"},
    DimensionWords{kFrequency, "a frequency", "30 Hz", "Hz"},
    DimensionWords{kAngle, "an angle", "30 deg", "rad"},
    DimensionWords{kAngularSpeed, "an angular speed", "10 deg/s", "rad/s"},
    DimensionWords{kSpeed, "a speed", "10 mm/s", "m/s"},
    DimensionWords{kAcceleration, "an acceleration", "9.81 m/s^2", "m/s^2"},
    DimensionWords{kDensity, "a density", "1060 kg/m^3", "kg/m^3"},
    DimensionWords{kForce, "a force", "0.2 N", "N"},
    DimensionWords{kForcePerLength, "a force per length or energy per area", "60 N/m", "N/m"},
    DimensionWords{kPressure, "a pressure", "12 kPa", "Pa"},
    DimensionWords{kForcePerVolume, "a force per volume", "10 kN/m^3", "N/m^3"},
    DimensionWords{kEnergy, "an energy or moment", "3 mJ", "J"},
    DimensionWords{{.length = 2, .mass = 1, .time = -3}, "a power", "2 W", "W"},
    DimensionWords{{.length = 3, .time = -1}, "a flow", "2 ml/s", "m^3/s"},
};

const DimensionWords* find_words(const Dimension& dimension) {
  const auto row =
      std::ranges::find_if(kDimensions, [&](const DimensionWords& words) { return words.dimension == dimension; });
  return row == kDimensions.end() ? nullptr : &*row;
}

bool is_space(char character) {
  return character == ' ' || character == '\t' || character == '\n';
}
bool is_digit(char character) {
  return character >= '0' && character <= '9';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// The prefix is larger than what goes with the unit.
[[noreturn]] void refuse_prefix(std::string_view symbol, const Prefix& prefix, const NamedUnit& named) {
  const std::string meant =
      prefix.symbol == "M" ? "; did you mean " + in_backticks("m" + std::string(named.symbol)) + "?" : "";
  throw QuantityError("unknown unit " + in_backticks(symbol) + ": " + in_backticks(prefix.symbol) +
                      " does not go with " + in_backticks(named.symbol) + meant);
}

std::optional<Unit> find_symbol(std::string_view symbol) {
  for (const NamedUnit& named : kUnits) {
    if (named.symbol == symbol) return named.unit;
  }
  for (const NamedUnit& named : kUnits) {
    if (named.prefixes == Prefixes::kNone || !symbol.ends_with(named.symbol)) continue;
    const std::string_view prefix = symbol.substr(0, symbol.size() - named.symbol.size());
    for (const Prefix& row : kPrefixes) {
      if (row.symbol != prefix) continue;
      if (named.prefixes == Prefixes::kUpToKilo && row.power_of_ten > kKilo) refuse_prefix(symbol, row, named);
      Unit unit = named.unit;
      unit.power_of_ten += row.power_of_ten;
      return unit;
    }
  }
  return std::nullopt;
}

/// The symbols that people mean when they mistype one.
std::string suggest_symbol(std::string_view symbol) {
  static const std::vector<std::string> common = {"mm",  "cm", "um",  "m",   "s",  "ms", "min", "deg",
                                                  "rad", "Pa", "kPa", "MPa", "N",  "mN", "kg",  "g",
                                                  "ml",  "l",  "J",   "kJ",  "mJ", "Hz", "bar", "mmHg"};
  return did_you_mean(symbol, common);
}

/// Units that people write in words, or of other systems, and what stands for them.
struct UnitAdvice {
  std::string_view written;
  std::string_view advice;
};
constexpr std::array kUnitAdvice = {
    UnitAdvice{"inch", "25.4 mm for each inch"},
    UnitAdvice{"inches", "25.4 mm for each inch"},
    UnitAdvice{"in", "25.4 mm for each inch"},
    UnitAdvice{"millimeter", "`mm`"},
    UnitAdvice{"millimetre", "`mm`"},
    UnitAdvice{"millimeters", "`mm`"},
    UnitAdvice{"millimetres", "`mm`"},
    UnitAdvice{"micron", "`um`"},
    UnitAdvice{"microns", "`um`"},
    UnitAdvice{"sec", "`s`"},
    UnitAdvice{"second", "`s`"},
    UnitAdvice{"seconds", "`s`"},
    UnitAdvice{"msec", "`ms`"},
    UnitAdvice{"usec", "`us`"},
    UnitAdvice{"degree", "`deg`"},
    UnitAdvice{"degrees", "`deg`"},
    UnitAdvice{"cc", "`ml`"},
    UnitAdvice{"psi", "6.895 kPa for each psi"},
    UnitAdvice{"atm", "101.325 kPa for each atm"},
    UnitAdvice{"hPa", "0.1 kPa for each hPa"},
    UnitAdvice{"Torr", "`mmHg`"},
    UnitAdvice{"torr", "`mmHg`"},
    UnitAdvice{"kgf", "9.80665 N for each kgf"},
    UnitAdvice{"gf", "9.80665 mN for each gf"},
    UnitAdvice{"dyn", "0.01 mN for each dyn"},
};

/// For a word that is misspelled; nullptr where none is near. Short ones are near to much.
const UnitAdvice* advice_near(std::string_view symbol) {
  constexpr std::size_t kLongWord = 5;  // letters
  std::vector<std::string> words;
  for (const UnitAdvice& row : kUnitAdvice) {
    if (row.written.size() >= kLongWord) words.emplace_back(row.written);
  }
  const auto row = std::ranges::find(kUnitAdvice, nearest_word(symbol, words), &UnitAdvice::written);
  return row == kUnitAdvice.end() ? nullptr : &*row;
}

/// How a power is written whose `^` has been left away: `m^2` of `m2`. Empty where it is none.
std::string power_of(std::string_view symbol) {
  const std::size_t digits = symbol.find_first_of("0123456789");
  if (digits == std::string_view::npos) return "";
  const std::string_view base = symbol.substr(0, digits), exponent = symbol.substr(digits);
  if (exponent.size() > 1 || !find_symbol(base)) return "";
  return std::string(base) + "^" + std::string(exponent);
}

[[noreturn]] void refuse_unit(std::string_view symbol) {
  const auto row = std::ranges::find(kUnitAdvice, symbol, &UnitAdvice::written);
  if (row != kUnitAdvice.end()) {
    throw QuantityError("unknown unit " + in_backticks(symbol) + ", write " + std::string(row->advice));
  }
  const std::string power = power_of(symbol);
  if (!power.empty()) throw QuantityError("unknown unit " + in_backticks(symbol) + ", write " + in_backticks(power));
  const std::string meant = suggest_symbol(symbol);
  const UnitAdvice* near = meant.empty() ? advice_near(symbol) : nullptr;
  throw QuantityError("unknown unit " + in_backticks(symbol) +
                      (near != nullptr ? ", write " + std::string(near->advice) : meant));
}

/// Takes the exponent off the end of a factor: `m^2`, `m²`, `s^-1`.
int split_exponent(std::string_view& factor) {
  for (const auto& [sign, exponent] : {std::pair<std::string_view, int>{"²", 2}, {"³", 3}}) {
    if (!factor.ends_with(sign)) continue;
    factor.remove_suffix(sign.size());
    return exponent;
  }
  const std::size_t caret = factor.find('^');
  if (caret == std::string_view::npos) return 1;
  std::string_view digits = trimmed(factor.substr(caret + 1));
  int exponent = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  if (result.ec != std::errc() || result.ptr != digits.data() + digits.size() || std::abs(exponent) > 9) {
    throw QuantityError("the exponent " + in_backticks(digits) + " of a unit is not a whole number from -9 to 9");
  }
  factor = trimmed(factor.substr(0, caret));
  return exponent;
}

void multiply(Unit& product, const Unit& factor, int exponent) {
  product.coefficient *= std::pow(factor.coefficient, exponent);
  product.power_of_ten += factor.power_of_ten * exponent;
  product.dimension.length += factor.dimension.length * exponent;
  product.dimension.mass += factor.dimension.mass * exponent;
  product.dimension.time += factor.dimension.time * exponent;
  product.dimension.angle += factor.dimension.angle * exponent;
}

Unit read_unit(std::string_view text) {
  constexpr int kMostFactors = 16;
  Unit product;
  std::string_view rest = text;
  int sign = 1;
  for (int count = 0; count < kMostFactors; ++count) {
    const std::size_t end = rest.find_first_of("*/");
    std::string_view factor = trimmed(rest.substr(0, end));
    const std::string_view whole = factor;
    const int exponent = split_exponent(factor);
    const std::optional<Unit> unit = find_symbol(factor);
    const bool is_one = whole == "1";
    if (whole.empty()) throw QuantityError("a unit is missing in " + in_backticks(text));
    if (!unit && !is_one) refuse_unit(factor);
    if (unit) multiply(product, *unit, sign * exponent);
    if (end == std::string_view::npos) return product;
    sign = rest[end] == '/' ? -1 : 1;
    rest.remove_prefix(end + 1);
  }
  throw QuantityError("the unit " + in_backticks(text) + " has more than 16 factors");
}

/// Length of the decimal number that the text begins with; 0 when it begins with none.
std::size_t number_length(std::string_view text) {
  std::size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const std::size_t mantissa = at;
  std::size_t digits = 0;
  while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) {
    if (text[at] == '.' && text.substr(mantissa, at - mantissa).find('.') != std::string_view::npos) break;
    if (is_digit(text[at])) ++digits;
    ++at;
  }
  if (digits == 0) return 0;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t exponent = at + 1;
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
    const std::size_t first = exponent;
    while (exponent < text.size() && is_digit(text[exponent])) ++exponent;
    if (exponent > first) at = exponent;
  }
  return at;
}

/// The decimal number times a power of ten, rounded once.
double scaled_number(std::string_view number, int power_of_ten) {
  constexpr std::size_t kLongestNumber = 200;
  if (number.size() > kLongestNumber) throw QuantityError("the number " + in_backticks(number) + " is too long");
  if (number.front() == '+') number.remove_prefix(1);
  int exponent = 0;
  const std::size_t e = number.find_first_of("eE");
  if (e != std::string_view::npos) {
    std::string_view digits = number.substr(e + 1);
    if (digits.front() == '+') digits.remove_prefix(1);
    if (std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec != std::errc()) exponent = 100000;
    exponent = std::clamp(exponent, -100000, 100000);
  }
  const std::string text = std::string(number.substr(0, e)) + "e" + std::to_string(exponent + power_of_ten);
  double value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc() || !std::isfinite(value)) {
    throw QuantityError("the number " + in_backticks(number) + " is beyond what a double can hold");
  }
  return value;
}

bool names_no_finite_number(std::string_view text) {
  std::string lower;
  for (const char character : text.substr(0, 10)) {
    lower += static_cast<char>(character >= 'A' && character <= 'Z' ? character - 'A' + 'a' : character);
  }
  std::string_view word = lower;
  while (!word.empty() && (word.front() == '+' || word.front() == '-' || word.front() == '.')) word.remove_prefix(1);
  if (!word.starts_with("nan") && !word.starts_with("inf")) return false;
  return word.size() == 3 || is_space(word[3]) || word.starts_with("infinity");
}

std::string join_si_factors(const Dimension& dimension) {
  std::string above;
  std::string below;
  for (const auto& [symbol, exponent] : {std::pair{"kg", dimension.mass}, std::pair{"m", dimension.length},
                                         std::pair{"s", dimension.time}, std::pair{"rad", dimension.angle}}) {
    if (exponent == 0) continue;
    const std::string power = std::abs(exponent) == 1 ? "" : "^" + std::to_string(std::abs(exponent));
    if (exponent > 0) above += (above.empty() ? "" : "*") + std::string(symbol) + power;
    if (exponent < 0) below += "/" + std::string(symbol) + power;
  }
  return (above.empty() && !below.empty() ? "1" : above) + below;
}

}  // namespace

Quantity parse_quantity(std::string_view text) {
  text = trimmed(text);
  const std::size_t length = number_length(text);
  if (length == 0) {
    if (names_no_finite_number(text)) throw QuantityError("it is not a finite number");
    if (text.starts_with("\u2212") || text.starts_with("\u2013")) {
      throw QuantityError("its minus sign is one of typography; write `-`");
    }
    const std::string parameter = text.starts_with("$") ? "; a parameter's value is written `${name}`" : "";
    throw QuantityError("it does not begin with a number" + parameter);
  }
  const std::string_view number = text.substr(0, length);
  const std::string_view unit_text = trimmed(text.substr(length));
  if (unit_text.starts_with(",")) throw QuantityError("a decimal point is needed, not a comma");
  if (begins_with_foreign_space(unit_text)) {
    throw QuantityError("the space before its unit is one of typography; write a plain one, or none");
  }
  const Unit unit = unit_text.empty() ? Unit{} : read_unit(unit_text);
  const double value = scaled_number(number, unit.power_of_ten) * unit.coefficient;
  if (!std::isfinite(value))
    throw QuantityError("the number " + in_backticks(number) + " is beyond what a double can hold");
  return {value, unit.dimension};
}

Quantity parse_unit(std::string_view text) {
  return parse_quantity("1 " + std::string(trimmed(text)));
}

std::string dimension_name(const Dimension& dimension) {
  const DimensionWords* words = find_words(dimension);
  return words ? std::string(words->name) : "a quantity in " + join_si_factors(dimension);
}

std::string dimension_example(const Dimension& dimension) {
  const DimensionWords* words = find_words(dimension);
  return words ? std::string(words->example) : "1 " + join_si_factors(dimension);
}

std::string si_unit(const Dimension& dimension) {
  const DimensionWords* words = find_words(dimension);
  return words ? std::string(words->si) : join_si_factors(dimension);
}

std::string format_like(double value, std::string_view example) {
  const std::string_view unit = trimmed(example.substr(number_length(example)));
  const double scale = unit.empty() ? 1 : parse_unit(unit).value;
  std::array<char, 40> number;
  std::snprintf(number.data(), number.size(), "%.6g", value / scale);
  return unit.empty() ? number.data() : std::string(number.data()) + " " + std::string(unit);
}

}  // namespace thinwall
