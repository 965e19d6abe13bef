#include "studio/golden/OverlayRecord.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

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

std::string shown(const Json& value) {
  return value.is_number() ? fmt::format("{:.6g}", value.get<double>()) : value.dump();
}

}  // namespace

std::string overlay_record(const OverlayContent& content) {
  const Json pressure = content.pressure ? Json(*content.pressure) : Json();
  const Json json = {{"title", content.title},           {"caption", content.caption},
                     {"phase", content.phase},           {"tool", content.tool},
                     {"time_s", content.time},           {"duration_s", content.duration},
                     {"force_N", content.force},         {"depth_m", content.depth},
                     {"pressure_Pa", pressure},          {"show_force_plot", content.show_force_plot},
                     {"show_gauge", content.show_gauge}, {"show_caption", content.show_caption},
                     {"show_time", content.show_time}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<std::string> compare_overlays(const std::string& golden, const std::string& today) {
  const Json before = Json::parse(golden, nullptr, false);
  const Json after = Json::parse(today, nullptr, false);
  std::vector<std::string> changes;
  if (!before.is_object() || !after.is_object()) return changes;
  for (const auto& [name, value] : after.items()) {
    if (!before.contains(name) || is_same(before.at(name), value)) continue;
    changes.push_back(name + " " + shown(value) + " instead of " + shown(before.at(name)));
  }
  return changes;
}

}  // namespace thinwall
