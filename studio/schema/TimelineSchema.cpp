#include "studio/schema/SchemaSections.hpp"

namespace thinwall {
namespace {

const KeySchema kTool{"tool", name_value(), false, {}, "which tool; may be left out when there is one only"};
const KeySchema kBody{"body", name_value(), false, {}, "which body; may be left out when there is one only"};

/// Keys that every clip has.
std::vector<KeySchema> with_clip_keys(std::vector<KeySchema> keys) {
  keys.push_back({"start",
                  usually(quantity_value(kTime, kFromZero, "2 s"), kUsualTimes),
                  false,
                  {},
                  "when the clip begins; when the one before it ends when absent"});
  keys.push_back({"caption", text_value(), false, {}, "shown while the clip lasts"});
  keys.push_back({"chapter",
                  text_value(),
                  false,
                  {},
                  "title of a chapter of the video that begins with the clip and lasts until the next one"});
  return keys;
}

/// `details` follow the documentation where there is room.
MappingSchema clip(const std::string& verb, const std::string& documentation, std::vector<KeySchema> keys,
                   const std::string& details = "") {
  MappingSchema action{.name = verb, .documentation = documentation + details, .keys = with_clip_keys(std::move(keys))};
  return {.name = "clip",
          .documentation = documentation,
          .keys = {{verb, mapping_value({action}), true, {}, documentation}}};
}

/// `lying`: what lies along the axis.
KeySchema axis_key(const std::string& lying) {
  return {"axis",
          direction_value(),
          false,
          {},
          "y' of the tool, along which " + lying + " lies, made perpendicular to the direction; world y when absent"};
}

MappingSchema palpate() {
  return clip(
      "palpate",
      "Presses a body and lets go. Where the line of approach meets no wall any more when the clip starts, as over a "
      "cut that gapes, the tool goes the way that it had when the run began, which a note tells; depth then counts "
      "from what it touches, at the latest from where the wall was.",
      {kTool,
       kBody,
       {"at", vector_value(kLength, {}, "[0, 0, 20 mm]"), false, "[0, 0, 0]", "a point of the line of approach"},
       {"direction", direction_value(), false, "[0, 0, -1]", "sense of the approach"},
       axis_key("a line"),
       {"depth",
        usually(quantity_value(kLength, kAboveZero, "4 mm"), kUsualLengths),
        true,
        {},
        "travel after first contact"},
       {"speed", usually(quantity_value(kSpeed, kAboveZero, "10 mm/s"), kUsualSpeeds), false, "10 mm/s",
        "speed of the tool"},
       {"hold", usually(quantity_value(kTime, kFromZero, "0.5 s"), kUsualTimes), false, "0 s",
        "time at full depth; until a step ends at least, where the tool's next clip leaves room for that"},
       {"standoff", usually(quantity_value(kLength, kAboveZero, "5 mm"), kUsualLengths), false, "5 mm",
        "distance from the surface at which the tool starts and to which it goes back"},
       {"withdraw", boolean_value(), false, "true", "whether the tool goes back"}});
}

MappingSchema pierce() {
  return clip(
      "pierce", "Pushes a needle through a wall and draws it out.",
      {kTool,
       kBody,
       {"at", vector_value(kLength, {}, "[0, 0, 20 mm]"), false, "[0, 0, 0]", "a point of the line of approach"},
       {"direction", direction_value(), false, "[0, 0, -1]", "sense of the approach"},
       axis_key("the slit"),
       {"depth",
        usually(quantity_value(kLength, kAboveZero, "12 mm"), kUsualLengths),
        true,
        {},
        "travel after first contact"},
       {"speed", usually(quantity_value(kSpeed, kAboveZero, "10 mm/s"), kUsualSpeeds), false, "10 mm/s",
        "speed of the needle"},
       {"hold", usually(quantity_value(kTime, kFromZero, "1 s"), kUsualTimes), false, "0 s",
        "time at full depth; until a step ends at least, where the tool's next clip leaves room for that"},
       {"standoff", usually(quantity_value(kLength, kAboveZero, "5 mm"), kUsualLengths), false, "5 mm",
        "distance from the surface at which the needle starts and to which it goes back"},
       {"withdraw", boolean_value(), false, "true", "whether the needle goes back"}},
      " The wall dents, and gives way once it would give back more energy with a slit of the needle's width in it than "
      "the slit costs (toughness times thickness times width). The slit lies along `axis`, or across that where there "
      "is no room so. From then on the wall slides along the needle under the tool's `friction` and lets nothing "
      "through; the puncture stays open when the needle has left. Where the body is "
      "less deep than `depth` the needle goes through its far wall too. A wall that is `fixed` cannot dent, so that no "
      "balance of energies says when it gives way: it gives way at once, the needle pays what the slit costs evenly "
      "over the length of its cone, and nothing there squeezes its shaft or opens the puncture. Where the line of "
      "approach meets no wall any more when the clip starts, as over a cut that gapes, the needle goes the way that it "
      "had when the run began, as with `palpate`. Errors are a depth larger than the needle is long, a needle as thick "
      "as the body is wide across its way, and one thinner than a thousandth of the triangles' edges; a needle that "
      "presses where no slit fits in, as next to a border, ends the run.");
}

ValueSchema path_of_points() {
  ValueSchema path = list_value(vector_value(kLength, {}, "[0, 0, 20 mm]"), 2);
  path.example = "[[0, 0, 20 mm], [5 mm, 0, 20 mm]]";
  return path;
}

MappingSchema incise() {
  return clip(
      "incise", "Presses a blade into a wall, draws it along a path and takes it out.",
      {kTool,
       kBody,
       {"path", path_of_points(), true, {}, "points that the middle of the edge passes below"},
       {"direction",
        direction_value(),
        false,
        {},
        "along which the points are brought to the surface, on an open one also the side that is cut into; to the "
        "nearest point when absent"},
       {"reach", usually(quantity_value(kLength, kAboveZero, "10 mm"), kUsualLengths), false, "10 mm",
        "how far the points may lie from the surface"},
       {"depth",
        usually(quantity_value(kLength, kAboveZero, "3 mm"), kUsualLengths),
        true,
        {},
        "how far below the path the edge goes, along the inward normal"},
       {"speed", usually(quantity_value(kSpeed, kAboveZero, "15 mm/s"), kUsualSpeeds), false, "10 mm/s",
        "speed in and out, and along the path on the surface"},
       {"hold", usually(quantity_value(kTime, kFromZero, "0.5 s"), kUsualTimes), false, "0 s",
        "time at the end of the path"},
       {"standoff", usually(quantity_value(kLength, kAboveZero, "5 mm"), kUsualLengths), false, "5 mm",
        "distance from the surface at which the blade starts and to which it goes back"},
       {"withdraw", boolean_value(), false, "true", "whether the blade goes back"},
       {"marked", boolean_value(), false, "false",
        "whether the path is drawn on the wall as with a pen when the clip starts, and the blade follows the line to "
        "where the wall takes it and turns with it; otherwise it follows the path in space"}},
      " The points are brought to the surface as it is when the clip starts; neighbours are joined by the curve in "
      "which the plane through both and the mean inward normal meets the surface, the shorter way round and straight "
      "on over open wounds. The blade's width lies along the path, and its middle follows it. Where the path turns "
      "back sharply the blade goes back without turning. The wall dents until the blade has put into it what a slit "
      "as long as the blade is wide would cost (toughness times thickness times width), at the latest until the "
      "blade moves on along the path; then the blade is in, and cuts the wall that its edge meets first. Where "
      "it stands beside a wall that rises before it, so that its edge meets none, it is in where the wall presses it "
      "most, once it has put that much into it. A sharp "
      "blade does not drag the wall along: the blade feels what new area costs beyond what the wall releases, but "
      "what holds the body does not. Where the wall alone releases more than new area costs the cut runs ahead of "
      "the blade, along the path and straight on beyond its end, until it does not or comes to a border or another "
      "cut, in each step by about the blade's width at most (or two triangles' edges); what is beyond the cost is "
      "`jump_J`, and the blade feels nothing until it is where the cut has run to. The run says that it did and by "
      "how much. Where a point has no wall any more when the clip starts, as over a cut that gapes, the blade goes the "
      "way that it had when the run began, which a note tells, and cuts on from the lip ahead of it. Errors are points "
      "out of reach or not joined by the wall, a depth larger than "
      "the blade is high or the body measures there, a blade that would start inside the body or touch it already, and "
      "one that is to cut a body while another blade does.");
}

MappingSchema move() {
  const std::string point = "[0, 0, 25 mm]";
  return clip(
      "move",
      "Takes a tool from one place to another, through what stands in its way. A needle or blade that is moved into a "
      "wall dents it: `pierce` and `incise` let it in.",
      {kTool,
       {"body",
        name_value(),
        false,
        {},
        "which body is meant, for readers: a tool touches each body that is in its way"},
       {"from",
        usually(vector_value(kLength, {}, point), kUsualPlaces),
        false,
        {},
        "where it starts; where it is when absent"},
       {"to", usually(vector_value(kLength, {}, point), kUsualPlaces), false, {}, "where it ends; needed without `by`"},
       {"by",
        usually(vector_value(kLength, {}, "[0, 0, 10 mm]"), kUsualPlaces),
        false,
        {},
        "the way from where it starts, instead of `to`: how far jaws lift what they hold"},
       {"direction",
        direction_value(),
        false,
        {},
        "z' of the tool at the end; when absent it keeps the one it has, and takes that of the motion in its first "
        "clip"},
       {"axis",
        direction_value(),
        false,
        {},
        "y' of the tool at the end, made perpendicular to the direction; when absent it turns no farther about "
        "z', and is world y in the tool's first clip"},
       {"for", usually(quantity_value(kTime, kAboveZero, "1 s"), kUsualTimes), false, "1 s", "how long it takes"},
       {"ease", word_value({"linear", "smooth"}), false, "smooth",
        "at constant speed, or starting and ending at rest"}},
      " The tool turns on its way, with the same `ease` and by the shortest turn, from the attitude that it has to the "
      "one given; where it goes nowhere, on the spot. Half a turn goes in the positive sense about its y' where "
      "`direction` alone is given, about its x' where `axis` is turned round too, and about its z' where `axis` alone "
      "is. In its first clip, and where `from` sets it elsewhere, it has the attitude given from the start.");
}

MappingSchema grasp() {
  return clip(
      "grasp", "Reaches over a wall with open forceps and closes the jaws, which hold it by friction.",
      {kTool,
       kBody,
       {"at", vector_value(kLength, {}, "[0, 0, 20 mm]"), false, "[0, 0, 0]",
        "a point of the line of approach, which may also "
        "meet the edge of a sheet or a flap from ahead"},
       {"direction", direction_value(), false, "[0, 0, -1]", "sense of the approach, z' of the tool"},
       {"axis", direction_value(), false, {}, "y' of the tool, along the width of the jaws, which close along x'"},
       {"depth",
        usually(quantity_value(kLength, kFromZero, "4 mm"), kUsualLengths),
        true,
        {},
        "how far the tips go beyond where the line of approach meets the wall"},
       {"speed", usually(quantity_value(kSpeed, kAboveZero, "10 mm/s"), kUsualSpeeds), false, "10 mm/s",
        "speed of the approach"},
       {"standoff", usually(quantity_value(kLength, kAboveZero, "5 mm"), kUsualLengths), false, "5 mm",
        "distance from the wall at which the tips start"},
       {"to", usually(quantity_value(kLength, kAboveZero, "1 mm"), kUsualLengths), false, "0.5 mm",
        "distance between the closed jaws: the wall that they leave less room than it is thick, in one layer or a "
        "fold, is "
        "squeezed between them"},
       {"grip",
        quantity_value(kForce, kAboveZero, "0.5 N"),
        false,
        {},
        "force at which the jaws stop closing; they close all the way when absent"},
       {"for", usually(quantity_value(kTime, kAboveZero, "1 s"), kUsualTimes), false, "1 s",
        "how long the jaws take to close"}});
}

MappingSchema release() {
  return clip(
      "release", "Opens the jaws of forceps where they are.",
      {kTool,
       {"for", usually(quantity_value(kTime, kAboveZero, "1 s"), kUsualTimes), false, "0.5 s", "how long it takes"}});
}

MappingSchema wait() {
  return clip("wait", "Lets time pass.",
              {{"for", usually(quantity_value(kTime, kAboveZero, "1 s"), kUsualTimes), false, "1 s", "how long"}});
}

MappingSchema fill(const std::string& verb, const std::string& documentation, const std::string& by) {
  return clip(verb, documentation,
              {kBody,
               {"chamber", name_value(), false, {}, "which chamber; may be left out when the body has one only"},
               {"by", usually(quantity_value(kVolume, kAboveZero, "5 ml"), kUsualVolumes), false, {}, by},
               {"to",
                quantity_value(kPressure, kFluidPressures, "2 kPa"),
                false,
                {},
                "pressure to be reached, instead of `by`"},
               {"for", usually(quantity_value(kTime, kAboveZero, "2 s"), kUsualTimes), false, "1 s",
                "how long it takes, at an even rate"}});
}

}  // namespace

ValueSchema timeline_schema() {
  return list_value(mapping_value(
      {palpate(), pierce(), incise(), grasp(), move(), release(),
       fill("inflate", "Fills fluid into a body.", "volume to be filled in"),
       fill("drain", "Takes fluid out of a body: less than it holds then.", "volume to be taken out"), wait()}));
}

namespace {

KeySchema length_key(const std::string& key, const std::string& standard, const std::string& documentation,
                     const UsualRange& usual = kUsualLengths) {
  return {key, usually(quantity_value(kLength, kAboveZero, standard), usual), false, standard, documentation};
}

/// The keys of a tool that pushes, and its friction.
std::vector<KeySchema> with_friction(std::vector<KeySchema> keys) {
  keys.push_back({"friction", usually(quantity_value(kDimensionless, kFromZero, "0.2"), kUsualFriction), false, "0",
                  "coefficient of Coulomb's law: the wall drags at the tool with at most so much of the normal force"});
  return keys;
}

KeySchema plate_size() {
  ValueSchema size = list_value(usually(quantity_value(kLength, kAboveZero), kUsualLengths), 1);
  size.maximum_items = 2;
  size.single = true;
  size.example = "[30 mm, 20 mm]";
  return {"size", size, false, "20 mm", "side of a square, or sides along x' and y'"};
}

KeySchema deviation_key() {
  return {"deviation",
          usually(quantity_value(kLength, kAboveZero, "0.2 mm"), kUsualLengths),
          false,
          {},
          "refines triangles where a cut would be farther than this off the blade's way, down to an eighth "
          "of their edges; when absent, cuts follow coarse triangles to about a quarter of their edges"};
}

}  // namespace

ValueSchema tools_schema() {
  MappingSchema tool{.name = "tool", .documentation = "What touches a body."};
  tool.selector = "kind";
  tool.cases = {
      {"point",
       "prescribes the three displacements where it touches; with a radius it is a ball of it",
       {{"radius",
         usually(quantity_value(kLength, kAboveZero, "1 mm"), kUsualLengths),
         false,
         {},
         "makes the tip a ball, whose force does not depend on the mesh as that of a point does"},
        {"friction",
         usually(quantity_value(kDimensionless, kFromZero, "0.2"), kUsualFriction),
         false,
         {},
         "coefficient of Coulomb's law of a tip with a radius; a bare point holds what it touches"}}},
      {"line",
       "a straight edge laid across the wall, prescribed like the point; of triangles that `fixed` holds in part the "
       "free corners go along with it",
       {length_key("length", "40 mm", "length of the edge")}},
      {"sphere", "a ball with a growing area of contact",
       with_friction({length_key("radius", "3 mm", "radius of the ball")})},
      {"capsule", "a round rod with round ends, laid across the direction along y'",
       with_friction({length_key("radius", "3 mm", "radius of the rod"),
                      length_key("length", "20 mm", "length over all; at least the diameter counts")})},
      {"plate", "a rigid plate with normal z', its edges rounded by 0.1 mm",
       with_friction({plate_size(), length_key("thickness", "2 mm", "thickness behind the face", kUsualThicknesses)})},
      {"needle", "a round shaft along z' that ends in a cone of four radii with a tip rounded by 0.4 radii",
       with_friction(
           {length_key("radius", "0.5 mm", "radius of the shaft"), length_key("length", "40 mm", "length over all")})},
      {"scalpel", "the flank and the edge of a blade, rounded by half its thickness",
       with_friction({length_key("width", "6 mm", "length of the edge, along y'"),
                      length_key("length", "20 mm", "height of the blade, along z'"),
                      length_key("thickness", "0.4 mm", "thickness of the blade, along x'", kUsualThicknesses),
                      deviation_key()})},
      {"forceps", "two jaws that open along x', with edges rounded by a quarter of the smallest of their sizes",
       with_friction({length_key("opening", "10 mm", "distance between the open jaws"),
                      length_key("length", "30 mm", "length of the jaws, along z'"),
                      length_key("width", "4 mm", "width of the jaws, along y'"),
                      length_key("thickness", "1.5 mm", "thickness of each jaw, along x'", kUsualThicknesses)})},
  };
  std::vector<std::string> kinds;
  for (const CaseSchema& kind : tool.cases) kinds.push_back(kind.word);
  tool.keys = {{"kind", word_value(std::move(kinds)), false, "point", "which kind of tool"}};
  return named_value(std::move(tool));
}

}  // namespace thinwall
