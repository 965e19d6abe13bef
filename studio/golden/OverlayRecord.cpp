#include "studio/golden/OverlayRecord.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "studio/schema/Quantity.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

bool is_same(const Json& a, const Json& b) {
  constexpr double kShown = 1e-3;
  if (!a.is_number() || !b.is_number()) return a == b;
  const double first = a.get<double>();
  const double second = b.get<double>();
  return std::abs(first - second) <= kShown * std::max(std::abs(first), std::abs(second));
}

/// A quantity of a record, whose SI unit its name ends with.
struct RecordedQuantity {
  const char* name;
  const char* spoken;
  const char* example;  // in the unit that it is told in
};

constexpr RecordedQuantity kQuantities[] = {{"time_s", "time", "1 s"},
                                            {"duration_s", "duration", "1 s"},
                                            {"force_N", "force", "1 N"},
                                            {"depth_m", "depth", "1 mm"},
                                            {"pressure_Pa", "pressure", "1 kPa"}};

/// In four digits, as the overlay has no more of them.
std::string shown(const Json& value, const char* example) {
  if (!value.is_number()) return value.dump();
  return format_like(std::stod(fmt::format("{:.4g}", value.get<double>())), example);
}

std::string told(const std::string& name, const Json& before, const Json& after) {
  const auto quantity = std::ranges::find(kQuantities, name, &RecordedQuantity::name);
  const bool is_known = quantity != std::end(kQuantities);
  const char* example = is_known ? quantity->example : "1";
  return (is_known ? quantity->spoken : name) + " " + shown(after, example) + " instead of " + shown(before, example);
}

}  // namespace

std::string overlay_record(const OverlayContent& content) {
  const Json pressure = content.pressure ? Json(*content.pressure) : Json();
  Json json = {{"title", content.title},   {"caption", content.caption}, {"phase", content.phase},
               {"tool", content.tool},     {"time_s", content.time},     {"duration_s", content.duration},
               {"force_N", content.force}, {"depth_m", content.depth},   {"pressure_Pa", pressure}};
  if (!content.pressurized_body.empty()) json["pressure_of"] = content.pressurized_body;
  for (const OverlayRow& row : kOverlayRows) json["show_" + std::string(row.key)] = content.shown.*row.is_shown;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<std::string> compare_overlays(const std::string& golden, const std::string& today) {
  const Json before = Json::parse(golden, nullptr, false);
  const Json after = Json::parse(today, nullptr, false);
  std::vector<std::string> changes;
  if (!before.is_object() || !after.is_object()) return changes;
  for (const auto& [name, value] : after.items()) {
    if (!before.contains(name) || is_same(before.at(name), value)) continue;
    changes.push_back(told(name, before.at(name), value));
  }
  return changes;
}

}  // namespace thinwall
