#include "studio/recorder/ResolvedPicture.hpp"

#include <nlohmann/json.hpp>

#include "renderer/look/FluidLooks.hpp"
#include "renderer/look/Ground.hpp"
#include "renderer/look/OrganLooks.hpp"
#include "studio/scenario/ResolvedCameras.hpp"
#include "studio/scenario/ResolvedTeaching.hpp"
#include "studio/scenario/ResolvedValues.hpp"
#include "studio/take/TakeError.hpp"

namespace thinwall {
namespace {

using SortedJson = nlohmann::json;

/// Takes of before there were kinds of organs name none.
TissueLook to_tissue_look(const SortedJson& body) {
  TissueLook look;
  if (body.contains("organ")) {
    const TissueLook* organ = find_organ_look(body.at("organ").get<std::string>());
    if (organ == nullptr) throw TakeError("the take's scenario names an organ that this program does not know");
    look = *organ;
  }
  if (body.contains("color")) look.color = body.at("color").get<Double3>();
  if (body.contains("roughness")) look.roughness = body.at("roughness");
  if (body.contains("wetness")) look.wetness = body.at("wetness");
  if (body.contains("contents")) {
    const FluidLook* fluid = find_fluid_look(body.at("contents").get<std::string>());
    if (fluid == nullptr) throw TakeError("the take's scenario names a fluid that this program does not know");
    look.contents = *fluid;
  }
  if (body.contains("bleeding")) look.bleeding = body.at("bleeding");
  return look;
}

DataView to_data(const SortedJson& data) {
  const DataQuantityRow* row = find_data_quantity(data.at("shows").get<std::string>());
  if (row == nullptr) throw TakeError("the take's scenario names a quantity that this program does not know");
  const DataScale* scale = find_data_scale(data.value("scale", "linear"));
  if (scale == nullptr) throw TakeError("the take's scenario names a scale of colours that this program does not know");
  DataView view{.quantity = row->quantity, .scale = *scale, .legend = find_corner(data, "legend")};
  if (data.contains("from")) view.from = data.at("from");
  if (data.contains("to")) view.to = data.at("to");
  return view;
}

/// Takes of before there were kinds of ground name none.
std::optional<Ground> to_ground(const SortedJson& look) {
  if (!look.contains("ground")) return std::nullopt;
  const Ground* ground = find_ground(look.at("ground").get<std::string>());
  if (ground == nullptr) throw TakeError("the take's scenario names a ground that this program does not know");
  return *ground;
}

LookDefinition to_look(const SortedJson& look) {
  LookDefinition result{.background = look.at("background").get<Double3>(), .bodies = {}};
  for (const auto& [name, body] : look.at("bodies").items()) result.bodies[name] = to_tissue_look(body);
  if (look.contains("data")) result.data = to_data(look.at("data"));
  result.ground = to_ground(look);
  result.mesh = look.value("mesh", false);
  return result;
}

OverlayChoice to_overlays(const SortedJson& overlays) {
  OverlayChoice choice;
  for (const OverlayRow& row : kOverlayRows) choice.*row.is_shown = overlays.at(row.key);
  return choice;
}

Tier to_tier(const std::string& word) {
  if (word == "draft") return Tier::kDraft;
  return word == "final" ? Tier::kFinal : Tier::kRecord;
}

PictureSettings to_settings(const SortedJson& scenario) {
  const SortedJson& lights = scenario.at("lights");
  const SortedJson& record = scenario.at("record");
  return {.view = {.camera = {},
                   .lights = {.key = lights.at("key"),
                              .fill = lights.at("fill"),
                              .environment = lights.at("environment"),
                              .key_direction = find_resolved<Double3>(lights, "key_direction"),
                              .endoscope = lights.value("endoscope", 0.0)},
                   .look = to_look(scenario.at("look"))},
          .overlays = to_overlays(scenario.at("look").at("overlays")),
          .record = {.size = {record.at("size").at(0), record.at("size").at(1)},
                     .frames_per_second = record.at("fps"),
                     .video = record.at("video"),
                     .tier = to_tier(record.at("tier"))}};
}

}  // namespace

PictureSettings picture_settings(const Scenario& scenario) {
  return {
      .view = scenario.view, .overlays = scenario.overlays, .record = scenario.record, .teaching = scenario.teaching};
}

PictureSettings picture_settings(const std::string& resolved) {
  try {
    PictureSettings settings = to_settings(SortedJson::parse(resolved));
    read_cameras(resolved, settings.view);
    read_teaching(resolved, settings.teaching, settings.view);
    return settings;
  } catch (const SortedJson::exception& error) {
    throw TakeError(std::string("the take's scenario cannot be read (") + error.what() + ")", "run the scenario again");
  }
}

std::map<std::string, std::string> tissue_kinds(const std::string& resolved) {
  std::map<std::string, std::string> kinds;
  const SortedJson scenario = SortedJson::parse(resolved, nullptr, false);
  if (!scenario.is_object() || !scenario.contains("look")) return kinds;
  for (const auto& [name, body] : scenario.at("look").at("bodies").items()) {
    if (body.contains("organ")) kinds[name] = body.at("organ").get<std::string>();
  }
  return kinds;
}

}  // namespace thinwall
