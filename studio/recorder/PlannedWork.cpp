#include "studio/recorder/PlannedWork.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "renderer/annotation/MaterialPoint.hpp"
#include "studio/scenario/ResolvedValues.hpp"
#include "studio/take/TakeError.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

double number(const Json& clip, const char* key) {
  return clip.value(key, 0.0);
}

Double3 sum(const Double3& a, const Double3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Double3 doubles(Vector3 place) {
  return {place.x, place.y, place.z};
}

double way_along(const std::vector<Double3>& places) {
  double way = 0;
  for (std::size_t i = 1; i < places.size(); ++i) way += length(vector3(places[i]) - vector3(places[i - 1]));
  return way;
}

/// Seconds from the stand-off to the depth, along the path, and back.
double time_at_speed(const Json& clip, const std::vector<Double3>& places) {
  const double speed = number(clip, "speed");
  if (!(speed > 0)) return 0;
  const double in = number(clip, "standoff") + number(clip, "depth");
  return ((clip.value("withdraw", false) ? 2 : 1) * in + way_along(places)) / speed;
}

/// What a clip does, without its times; `tips` are where clips have left the tools.
PlannedWork work_of(const Json& clip, std::map<std::string, Double3>& tips) {
  PlannedWork work{.tool = clip.value("tool", ""), .body = clip.value("body", ""), .depth = number(clip, "depth")};
  if (clip.contains("path")) {
    work.places = clip.at("path").get<std::vector<Double3>>();
    work.direction = find_resolved<Double3>(clip, "direction");
  } else if (clip.contains("at")) {
    work.places = {clip.at("at").get<Double3>()};
    work.direction = clip.at("direction").get<Double3>();
  } else if (!work.tool.empty()) {
    // A move is where it is told to be, whatever lies around.
    work.body.clear();
    if (const auto from = find_resolved<Double3>(clip, "from")) tips[work.tool] = *from;
    if (tips.contains(work.tool)) work.places.push_back(tips.at(work.tool));
    if (clip.contains("by") && !work.places.empty()) {
      work.places.push_back(sum(work.places.back(), clip.at("by").get<Double3>()));
    }
    if (clip.contains("to") && clip.at("to").is_array()) work.places.push_back(clip.at("to").get<Double3>());
  }
  if (!work.places.empty()) tips[work.tool] = work.places.back();
  return work;
}

/// Places between two of a path, both included.
std::vector<Double3> along(const Double3& from, const Double3& to) {
  constexpr int kParts = 6;
  std::vector<Double3> places;
  for (int i = 0; i <= kParts; ++i) {
    places.push_back(doubles(vector3(from) + (static_cast<double>(i) / kParts) * (vector3(to) - vector3(from))));
  }
  return places;
}

std::optional<Vector3> on_wall(const PlannedWork& work, const SnapshotSurface& wall, const Double3& place) {
  if (work.direction) return first_met(wall, vector3(place), vector3(*work.direction));
  const auto point = nearest_material_point(*wall.topology, place);
  return point ? std::optional(place_of(*point, wall)) : std::nullopt;
}

}  // namespace

std::vector<PlannedWork> planned_work(const std::string& resolved) {
  std::vector<PlannedWork> all;
  try {
    std::map<std::string, Double3> tips;
    double end_of_last = 0;
    const Json scenario = Json::parse(resolved, nullptr, false);
    if (!scenario.is_object()) return all;
    for (const Json& item : scenario.value("timeline", Json::array())) {
      const Json& clip = item.begin().value();
      PlannedWork work = work_of(clip, tips);
      work.begin = clip.value("start", end_of_last);
      work.end = end_of_last =
          work.begin + time_at_speed(clip, work.places) + number(clip, "hold") + number(clip, "for");
      if (!work.places.empty()) all.push_back(std::move(work));
    }
  } catch (const Json::exception& error) {
    throw TakeError(std::string("the take's scenario cannot be read (") + error.what() + ")", "run the scenario again");
  }
  return all;
}

std::vector<Double3> places_of(const PlannedWork& work, const Snapshot& first) {
  std::vector<Double3> way = {work.places.front()};
  for (std::size_t i = 1; i < work.places.size(); ++i) {
    const std::vector<Double3> part = along(work.places[i - 1], work.places[i]);
    way.insert(way.end(), part.begin() + 1, part.end());
  }
  const auto wall = std::ranges::find(first.surfaces, work.body, &SnapshotSurface::body);
  if (wall == first.surfaces.end()) return way;
  std::vector<Double3> places;
  for (const Double3& place : way) {
    const Vector3 met = on_wall(work, *wall, place).value_or(vector3(place));
    places.push_back(doubles(met));
    if (work.direction) places.push_back(doubles(met + work.depth * vector3(*work.direction)));
  }
  return places;
}

}  // namespace thinwall
