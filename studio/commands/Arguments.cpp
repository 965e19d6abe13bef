#include "studio/commands/Arguments.hpp"

#include <charconv>
#include <cmath>

#include "studio/commands/ExitCode.hpp"
#include "studio/schema/Quantity.hpp"

namespace thinwall {
namespace {

bool read_side(const char*& place, const char* end, int& side) {
  const auto [next, error] = std::from_chars(place, end, side);
  place = next;
  return error == std::errc() && side >= 16 && side <= 8192 && side % 2 == 0;
}

}  // namespace

Overrides parse_overrides(const std::vector<std::string>& texts) {
  Overrides overrides;
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw UsageError("--set " + text + ": write the parameter as name=value, for example --set depth=4mm");
    }
    overrides.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return overrides;
}

ImageSize parse_size(const std::string& text) {
  ImageSize size;
  const char* place = text.data();
  const char* const end = place + text.size();
  const bool good = read_side(place, end, size.width) && place != end && *place++ == 'x' &&
                    read_side(place, end, size.height) && place == end;
  if (!good) throw UsageError("--size " + text + ": write WIDTHxHEIGHT in pixels, even and from 16 to 8192");
  return size;
}

namespace {

/// Seconds, of either sign.
double read_time(const std::string& option, const std::string& text) {
  const std::string given = option + text;
  Quantity time;
  try {
    time = parse_quantity(text);
  } catch (const QuantityError& error) {
    throw UsageError(given + ": " + error.what());
  }
  if (time.dimension != kTime && time.dimension != Dimension{}) {
    throw UsageError(given + ": this is " + dimension_name(time.dimension) + ", not a time; write 1.5s");
  }
  return time.value;
}

}  // namespace

double parse_time(const std::string& option, const std::string& text) {
  const double time = read_time(option, text);
  if (time < 0) throw UsageError(option + text + ": a scenario begins at 0 s");
  return time;
}

double parse_duration(const std::string& option, const std::string& text) {
  const double time = read_time(option, text);
  if (!(time > 0)) throw UsageError(option + text + ": it must last longer than 0 s; write 5s");
  return time;
}

std::string data_words() {
  std::string words;
  for (const DataQuantityRow& row : data_quantities()) words += (words.empty() ? "" : ", ") + std::string(row.word);
  return words;
}

DataQuantity parse_data_quantity(const std::string& text) {
  const DataQuantityRow* row = find_data_quantity(text);
  if (row == nullptr) throw UsageError("--data " + text + ": there is no such quantity; choose one of " + data_words());
  return row->quantity;
}

DataScale parse_data_scale(const std::string& text) {
  const DataScale* scale = find_data_scale(text);
  if (scale == nullptr) {
    std::string words;
    for (const auto& [word, of_word] : kDataScales) words += (words.empty() ? "" : ", ") + std::string(word);
    throw UsageError("--data-scale " + text + ": there is no such scale; choose one of " + words);
  }
  return *scale;
}

Quantity parse_data_end(const std::string& option, const std::string& text) {
  try {
    return parse_quantity(text);
  } catch (const QuantityError& error) {
    throw UsageError(option + " " + text + ": " + error.what());
  }
}

}  // namespace thinwall
