#include "studio/scenario/SchemaSections.hpp"

namespace thinwall {
namespace {

const KeySchema kTool{"tool", name_value(), false, {}, "which tool; may be left out when there is one only"};
const KeySchema kBody{"body", name_value(), false, {}, "which body; may be left out when there is one only"};

/// Keys that every clip has.
std::vector<KeySchema> with_clip_keys(std::vector<KeySchema> keys) {
  keys.push_back({"start",
                  quantity_value(kTime, kFromZero, "2 s"),
                  false,
                  {},
                  "when the clip begins; when the one before it ends when absent"});
  keys.push_back({"caption", text_value(), false, {}, "shown while the clip lasts"});
  keys.push_back({"chapter", text_value(), false, {}, "title of a chapter of the video that begins with the clip"});
  return keys;
}

MappingSchema clip(const std::string& verb, const std::string& documentation, std::vector<KeySchema> keys) {
  MappingSchema action{.name = verb, .documentation = documentation, .keys = with_clip_keys(std::move(keys))};
  return {.name = "clip",
          .documentation = documentation,
          .keys = {{verb, mapping_value({action}), true, {}, documentation}}};
}

KeySchema axis_key() {
  return {"axis",
          direction_value(),
          false,
          {},
          "y' of the tool, along which a line lies, made perpendicular to the direction; world y when absent"};
}

MappingSchema palpate() {
  return clip(
      "palpate", "Presses a body and lets go.",
      {kTool,
       kBody,
       {"at", vector_value(kLength, {}, "[0, 0, 20 mm]"), false, "[0, 0, 0]", "a point of the line of approach"},
       {"direction", direction_value(), false, "[0, 0, -1]", "sense of the approach"},
       axis_key(),
       {"depth", quantity_value(kLength, kAboveZero, "4 mm"), true, {}, "travel after first contact"},
       {"speed", quantity_value(kSpeed, kAboveZero, "10 mm/s"), false, "10 mm/s", "speed of the tool"},
       {"hold", quantity_value(kTime, kFromZero, "0.5 s"), false, "0 s", "time at full depth"},
       {"standoff", quantity_value(kLength, kFromZero, "5 mm"), false, "5 mm",
        "distance from the surface at which the tool starts and to which it goes back"},
       {"withdraw", boolean_value(), false, "true", "whether the tool goes back"}});
}

MappingSchema move() {
  const std::string point = "[0, 0, 25 mm]";
  return clip("move", "Takes a tool from one place to another, through what stands in its way.",
              {kTool,
               {"body", name_value(), false, {}, "the body that a point or line may touch; the only one when absent"},
               {"from", vector_value(kLength, {}, point), false, {}, "where it starts; where it is when absent"},
               {"to", vector_value(kLength, {}, point), true, {}, "where it ends"},
               {"direction", direction_value(), false, {}, "z' of the tool; that of the motion when absent"},
               axis_key(),
               {"for", quantity_value(kTime, kAboveZero, "1 s"), false, "1 s", "how long it takes"},
               {"ease", word_value({"linear", "smooth"}), false, "smooth",
                "at constant speed, or starting and ending at rest"}});
}

MappingSchema wait() {
  return clip("wait", "Lets time pass.", {{"for", quantity_value(kTime, kAboveZero, "1 s"), false, "1 s", "how long"}});
}

MappingSchema fill(const std::string& verb, const std::string& documentation, const std::string& by) {
  return clip(verb, documentation,
              {kBody,
               {"chamber", name_value(), false, {}, "which chamber; may be left out when the body has one only"},
               {"by", quantity_value(kVolume, kAboveZero, "5 ml"), false, {}, by},
               {"to", quantity_value(kPressure, {}, "2 kPa"), false, {}, "pressure to be reached, instead of `by`"},
               {"for", quantity_value(kTime, kAboveZero, "2 s"), false, "1 s", "how long it takes, at an even rate"}});
}

}  // namespace

ValueSchema timeline_schema() {
  return list_value(
      mapping_value({palpate(), move(), fill("inflate", "Fills fluid into a body.", "volume to be filled in"),
                     fill("drain", "Takes fluid out of a body.", "volume to be taken out"), wait()}));
}

ValueSchema tools_schema() {
  ValueSchema no_friction = quantity_value(kDimensionless, kFromZero, "0.2");
  no_friction.only_zero = true;
  MappingSchema tool{.name = "tool", .documentation = "What touches a body."};
  tool.selector = "kind";
  tool.cases = {
      {"point", "prescribes the three displacements where it touches", {}},
      {"line",
       "a straight edge laid across the wall, prescribed like the point",
       {{"length", quantity_value(kLength, kAboveZero, "40 mm"), false, "40 mm", "length of the edge"}}},
      {"sphere",
       "a ball with a growing area of contact",
       {{"radius", quantity_value(kLength, kAboveZero, "3 mm"), false, "3 mm", "radius of the ball"},
        {"friction", no_friction, false, "0", "coefficient of friction"}}},
  };
  tool.keys = {{"kind", word_value({"point", "line", "sphere"}), false, "point", "which kind of tool"}};
  return named_value(std::move(tool));
}

}  // namespace thinwall
