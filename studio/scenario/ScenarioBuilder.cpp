#include "studio/scenario/ScenarioBuilder.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "renderer/image/PictureCorner.hpp"
#include "renderer/look/FluidLooks.hpp"
#include "renderer/look/Ground.hpp"
#include "renderer/look/OrganLooks.hpp"
#include "studio/scenario/CheckedReading.hpp"
#include "studio/scenario/ClipBuilder.hpp"
#include "studio/scenario/FieldBuilder.hpp"
#include "studio/schema/ExpectationQuantity.hpp"

namespace thinwall {
namespace {

Double3 to_double3(const CheckedValue& list) {
  return {list.items[0].number, list.items[1].number, list.items[2].number};
}

std::optional<Double3> find_double3(const CheckedValue& mapping, std::string_view key) {
  const CheckedValue* list = mapping.find(key);
  return list == nullptr ? std::nullopt : std::optional(to_double3(*list));
}

/// The enumerator of a word; the schema lets no other word through.
template <typename Enumeration, std::size_t count>
Enumeration of_word(const std::string& word, const std::array<std::pair<std::string_view, Enumeration>, count>& words) {
  for (const auto& [name, value] : words) {
    if (name == word) return value;
  }
  assert(false);
  return words[0].second;
}

// Bodies.

constexpr std::array<std::pair<std::string_view, Shape>, 8> kShapes = {{{"sphere", Shape::kSphere},
                                                                        {"hemisphere", Shape::kHemisphere},
                                                                        {"semicylinder", Shape::kSemicylinder},
                                                                        {"sheet", Shape::kSheet},
                                                                        {"disc", Shape::kDisc},
                                                                        {"cylinder", Shape::kCylinder},
                                                                        {"annulus", Shape::kAnnulus},
                                                                        {"strip", Shape::kStrip}}};

constexpr std::array<std::pair<std::string_view, FluidKind>, 3> kFluids = {
    {{"none", FluidKind::kNone},
     {"incompressible", FluidKind::kIncompressible},
     {"compressible", FluidKind::kCompressible}}};

std::optional<SurfacePlacement> to_placement(const CheckedValue& surface) {
  SurfacePlacement placement{.at = to_vector(surface.at("at"))};
  const CheckedValue* turned = surface.find("turned");
  if (turned == nullptr && placement.at.isZero(0)) return std::nullopt;
  if (turned != nullptr) {
    placement.turned = Eigen::AngleAxisd(turned->at("by").number, to_vector(turned->at("about")).normalized());
  }
  return placement;
}

std::variant<MeshFileSource, ShapeSource> to_surface(const CheckedValue& surface) {
  if (const CheckedValue* mesh = surface.find("mesh")) {
    return MeshFileSource{.file = mesh->text,
                          .unit = surface.at("unit").number,
                          .repair = surface.at("repair").boolean,
                          .edge_length = find_number(surface, "remesh").value_or(0),
                          .placed = to_placement(surface)};
  }
  ShapeSource shape{.shape = of_word(surface.at("shape").text, kShapes), .placed = to_placement(surface)};
  shape.triangles = static_cast<int>(surface.at("triangles").number);
  shape.radius = find_number(surface, "radius").value_or(shape.radius);
  shape.inner_radius = find_number(surface, "inner_radius").value_or(shape.inner_radius);
  if (const CheckedValue* slit = surface.find("slit")) shape.slit = slit->boolean;
  shape.length = find_number(surface, "length").value_or(shape.length);
  shape.width = find_number(surface, "width").value_or(shape.width);
  return shape;
}

void read_fixed(const CheckedValue& fixed, BodyScenario& body) {
  for (const CheckedValue& part : fixed.items) {
    FixedRegion region{to_region(part.at("region")), {false, false, false}};
    for (const char axis : part.at("axes").text) region.axes[static_cast<std::size_t>(axis - 'x')] = true;
    region.clamped = part.at("clamped").boolean;
    body.fixed.push_back(std::move(region));
    body.fixed_locations.push_back(part.at("region").location);
  }
}

void read_loads(const CheckedValue& loads, BodyScenario& body) {
  constexpr std::array<std::pair<std::string_view, LoadKind>, 6> kinds = {{{"pressure", LoadKind::kFollowerPressure},
                                                                           {"force", LoadKind::kDeadForce},
                                                                           {"line_force", LoadKind::kDeadLineForce},
                                                                           {"moment", LoadKind::kDeadMoment},
                                                                           {"traction", LoadKind::kDeadTraction},
                                                                           {"body_force", LoadKind::kDeadBodyForce}}};
  for (const CheckedValue& item : loads.items) {
    LoadScenario load{.location = item.location};
    load.load.region = to_region(item.at("region"));
    for (const auto& [word, kind] : kinds) {
      const CheckedValue* value = item.find(word);
      if (value == nullptr) continue;
      load.load.kind = kind;
      if (kind == LoadKind::kFollowerPressure) {
        load.load.pressure = value->number;
      } else {
        load.load.vector = to_vector(*value);
      }
    }
    if (const CheckedValue* over = item.find("over")) {
      for (const CheckedValue& point : over->items) load.over.push_back({point.items[0].number, point.items[1].number});
    }
    body.loads.push_back(std::move(load));
  }
}

void read_chambers(const CheckedValue& contents, BodyScenario& body) {
  FluidDefinition& fluid = body.fluid;
  const CheckedValue* chambers = contents.find("chambers");
  if (chambers == nullptr) return;
  for (const CheckedMember& chamber : chambers->members) {
    const CheckedValue& at = chamber.value.at("at");
    fluid.chambers.push_back({chamber.key, to_vector(at), find_number(chamber.value, "pressure")});
    body.chamber_locations.push_back(at.location);
  }
  const auto index_of = [&](const std::string& name) {
    int index = 0;
    while (fluid.chambers[index].name != name) ++index;
    return index;
  };
  for (const CheckedValue& orifice : contents.at("orifices").items) {
    const CheckedValue& between = orifice.at("between");
    fluid.orifices.push_back({.from = index_of(between.items[0].text),
                              .to = index_of(between.items[1].text),
                              .area = orifice.at("area").number,
                              .discharge = orifice.at("discharge").number});
  }
}

BodyScenario to_body(const CheckedMember& member) {
  const CheckedValue& wall = member.value.at("wall");
  const CheckedValue& contents = member.value.at("contents");
  BodyScenario body{.name = member.key, .location = member.location};
  for (const CheckedMember& key : member.value.members) {
    if (key.key == "surface") body.surface_location = key.location;
  }
  body.surface = to_surface(member.value.at("surface"));
  body.thickness = to_number_field(wall.at("thickness"));
  body.model = wall.at("model").text == "shell" ? WallModel::kShell : WallModel::kMembrane;
  body.density = wall.at("density").number;
  read_material(wall.at("material"), body);
  if (const CheckedValue* fibres = wall.find("fibres")) body.fibres = to_direction_field(*fibres);
  body.tension_field = wall.at("tension_field").boolean;
  body.prestretch = to_prestretch_field(wall.at("prestretch"));
  if (const CheckedValue* toughness = wall.find("toughness")) body.toughness = to_number_field(*toughness);
  body.fluid.kind = of_word(contents.at("fluid").text, kFluids);
  body.fluid.initial_pressure = find_number(contents, "pressure");
  body.fluid.density = find_number(contents, "density").value_or(body.fluid.density);
  body.fluid.bulk_modulus = find_number(contents, "bulk_modulus").value_or(body.fluid.bulk_modulus);
  if (const CheckedValue* leaks = contents.find("leaks")) body.fluid.leaks = leaks->boolean;
  body.fluid.discharge = find_number(contents, "discharge").value_or(body.fluid.discharge);
  read_chambers(contents, body);
  for (const CheckedValue& term : wall.at("viscosity").items) {
    body.viscosity.push_back({.fraction = term.at("fraction").number, .time = term.at("time").number});
  }
  const CheckedValue& damping = wall.at("damping");
  body.damping = {.mass_rate = damping.at("mass_rate").number, .stiffness_time = damping.at("stiffness_time").number};
  read_fixed(member.value.at("fixed"), body);
  read_loads(member.value.at("loads"), body);
  return body;
}

// Tools and timeline.

ToolKind to_tool_kind(const std::string& word) {
  const auto known = std::ranges::find(kToolKindNames, word);
  assert(known != kToolKindNames.end());
  return static_cast<ToolKind>(known - kToolKindNames.begin());
}

ToolDefinition to_tool(const CheckedMember& member) {
  const CheckedValue& value = member.value;
  ToolDefinition tool{.name = member.key, .kind = to_tool_kind(value.at("kind").text)};
  tool.length = find_number(value, "length").value_or(0);
  tool.radius = find_number(value, "radius").value_or(0);
  tool.width = find_number(value, "width").value_or(0);
  tool.thickness = find_number(value, "thickness").value_or(0);
  tool.opening = find_number(value, "opening").value_or(0);
  tool.deviation = find_number(value, "deviation").value_or(0);
  tool.friction = find_number(value, "friction").value_or(0);
  if (const CheckedValue* size = value.find("size")) {
    tool.width = size->items.front().number;
    tool.length = size->items.back().number;
  }
  if (tool.kind == ToolKind::kPoint && tool.radius > 0) tool.kind = ToolKind::kSphere;
  return tool;
}

// Picture and record.

LightsDefinition to_lights(const CheckedValue& lights) {
  return {.key = lights.at("key").number,
          .fill = lights.at("fill").number,
          .environment = lights.at("environment").number,
          .key_direction = find_double3(lights, "key_direction"),
          .endoscope = lights.at("endoscope").number};
}

TissueLook to_tissue_look(const CheckedValue& body) {
  TissueLook look = *find_organ_look(body.at("organ").text);
  if (body.find("color") != nullptr) look.color = to_double3(body.at("color"));
  if (body.find("roughness") != nullptr) look.roughness = body.at("roughness").number;
  if (body.find("wetness") != nullptr) look.wetness = body.at("wetness").number;
  if (body.find("contents") != nullptr) look.contents = *find_fluid_look(body.at("contents").text);
  if (body.find("bleeding") != nullptr) look.bleeding = body.at("bleeding").number;
  return look;
}

PictureCorner to_corner(const std::string& word) {
  return static_cast<PictureCorner>(std::ranges::find(kCornerWords, word) - kCornerWords.begin());
}

LookDefinition to_look(const CheckedValue& look) {
  LookDefinition result{.background = to_double3(look.at("background")), .bodies = {}};
  for (const CheckedMember& body : look.at("bodies").members) result.bodies[body.key] = to_tissue_look(body.value);
  if (const CheckedValue* data = look.find("data")) {
    result.data = DataView{.quantity = find_data_quantity(data->at("shows").text)->quantity,
                           .from = find_number(*data, "from"),
                           .to = find_number(*data, "to"),
                           .scale = of_word(data->at("scale").text, kDataScales)};
    if (const CheckedValue* legend = data->find("legend")) result.data->legend = to_corner(legend->text);
  }
  if (const CheckedValue* ground = look.find("ground")) result.ground = of_word(ground->text, kGrounds);
  result.mesh = look.at("mesh").boolean;
  return result;
}

constexpr std::array<std::pair<std::string_view, Tier>, 3> kTiers = {
    {{"draft", Tier::kDraft}, {"record", Tier::kRecord}, {"final", Tier::kFinal}}};

RecordOptions to_record(const CheckedValue& record) {
  const CheckedValue& size = record.at("size");
  return {.size = {static_cast<int>(size.items[0].number), static_cast<int>(size.items[1].number)},
          .frames_per_second = record.at("fps").number,
          .video = record.at("video").boolean,
          .tier = of_word(record.at("tier").text, kTiers)};
}

GoldenDefinition to_golden(const CheckedValue& golden) {
  return {.at = find_number(golden, "at").value_or(0),
          .video = static_cast<int>(find_number(golden, "video").value_or(0)),
          .max = golden.at("max").number,
          .mean = golden.at("mean").number,
          .drift = golden.at("drift").number,
          .failing = find_number(golden, "failing"),
          .level = static_cast<int>(golden.at("level").number),
          .shift = static_cast<int>(golden.at("shift").number),
          .similarity = find_number(golden, "ssim"),
          .flip = find_number(golden, "flip"),
          .why = golden.at("why").text,
          .location = golden.location};
}

Expectation to_expectation(const CheckedValue& value) {
  Expectation expectation{.quantity = value.at("quantity").text, .location = value.location};
  const ExpectationQuantity quantity = find_expectation_quantity(expectation.quantity);
  expectation.subject = value.at(subject_word(quantity.measured->subject)).text;
  if (const CheckedValue* chamber = value.find("chamber")) expectation.chamber = chamber->text;
  expectation.at = find_number(value, "at");
  expectation.from = find_number(value, "from");
  expectation.until = find_number(value, "until");
  if (const CheckedValue* within = value.find("within")) {
    expectation.lowest = within->items[0].number;
    expectation.highest = within->items[1].number;
    return expectation;
  }
  const double expected = value.at("value").number;
  const double allowed = value.at("tolerance").number;
  expectation.lowest = expected - allowed;
  expectation.highest = expected + allowed;
  return expectation;
}

std::vector<CameraPlace> camera_places(const CheckedValue& root) {
  std::vector<CameraPlace> places;
  const auto add = [&](const std::string& name, const CheckedValue& camera) {
    if (const CheckedValue* position = camera.find("position")) places.push_back({name, {}, position->location});
    const CheckedValue* keyframes = camera.find("keyframes");
    for (std::size_t i = 0; keyframes != nullptr && i < keyframes->items.size(); ++i) {
      if (const CheckedValue* position = keyframes->items[i].find("position")) {
        places.push_back({name, i, position->location});
      }
    }
  };
  if (const CheckedValue* camera = root.find("camera")) add("", *camera);
  const CheckedValue* cameras = root.find("cameras");
  if (cameras == nullptr) return places;
  for (const CheckedMember& member : cameras->members) add(member.key, member.value);
  return places;
}

}  // namespace

Scenario build_scenario(const CheckedValue& root) {
  Scenario scenario;
  scenario.title = find_text(root, "title").value_or("");
  for (const CheckedMember& body : root.at("bodies").members) scenario.bodies.push_back(to_body(body));
  for (const CheckedMember& tool : root.at("tools").members) scenario.tools.push_back(to_tool(tool));
  for (const CheckedValue& clip : root.at("timeline").items) {
    scenario.timeline.push_back(to_clip(clip));
    scenario.timeline.back().number = static_cast<int>(scenario.timeline.size());
  }
  const CheckedValue& simulation = root.at("simulation");
  scenario.simulation.analysis =
      simulation.at("analysis").text == "dynamic" ? Analysis::kDynamic : Analysis::kQuasiStatic;
  scenario.simulation.time_step = simulation.at("time_step").number;
  scenario.simulation.gravity = to_vector(simulation.at("gravity"));
  scenario.simulation.step_error = find_number(simulation, "step_error").value_or(0);
  scenario.simulation.tolerance = simulation.at("tolerance").number;
  scenario.camera_places = camera_places(root);
  scenario.view.lights = to_lights(root.at("lights"));
  scenario.view.look = to_look(root.at("look"));
  const CheckedValue& overlays = root.at("look").at("overlays");
  for (const OverlayRow& row : kOverlayRows) {
    scenario.overlays.*row.is_shown = overlays.at(std::string(row.key)).boolean;
  }
  scenario.record = to_record(root.at("record"));
  for (const CheckedMember& point : root.at("record").at("points").members) {
    scenario.record.points.push_back({point.key, point.value.at("body").text, to_vector(point.value.at("at"))});
  }
  for (const CheckedValue& value : root.at("expect").items) scenario.expectations.push_back(to_expectation(value));
  for (const CheckedValue& golden : root.at("golden").items) scenario.goldens.push_back(to_golden(golden));
  return scenario;
}

}  // namespace thinwall
