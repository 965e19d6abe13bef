#include "studio/schema/SchemaSections.hpp"

namespace thinwall {
namespace {

KeySchema length_key(const std::string& key, const std::string& fallback, const std::string& documentation) {
  return {key, quantity_value(kLength, kAboveZero, fallback), false, fallback, documentation};
}

/// The shapes with the keys that each has besides `triangles`.
std::vector<CaseSchema> shape_cases() {
  const KeySchema radius = length_key("radius", "20 mm", "radius");
  const KeySchema along_y = length_key("length", "40 mm", "extent along y");
  const KeySchema along_x = length_key("width", "40 mm", "extent along x");
  const KeySchema hole = length_key("inner_radius", "10 mm", "radius of the hole");
  const KeySchema slit = {"slit", boolean_value(), false, "false",
                          "cut open along +x; groups `slit_start`, from which the ring goes counter-clockwise, and "
                          "`slit_end`"};
  return {
      {"sphere", "closed sphere", {radius}},
      {"hemisphere", "base on z = 0, closed by a cap; crown towards +z; 64 triangles give the 41-node mesh", {radius}},
      {"semicylinder",
       "base on z = 0, axis along y, closed by caps, which only corners bear where they meet: hold `base`",
       {radius, along_y}},
      {"sheet", "open rectangle in z = 0", {along_y, along_x}},
      {"disc", "open disc in z = 0", {radius}},
      {"cylinder", "axis along y, closed by caps at both ends", {radius, along_y}},
      {"annulus", "open ring in z = 0, its circles the groups `inner` and `outer`", {radius, hole, slit}},
      {"strip", "open narrow rectangle in z = 0", {along_y, along_x}},
  };
}

/// Pascal, as the moduli of walls: beyond what any matter has, and what a solver's numbers hold.
constexpr Range kBulkModuli{.minimum = 0, .maximum = 1e13, .minimum_excluded = true};

/// Pictures and takes hold places in single precision, to 8 micrometres there.
constexpr Range kPlaces{.minimum = -100, .maximum = 100};

std::vector<KeySchema> placement_keys() {
  MappingSchema turned{.name = "turned", .documentation = "A turn about an axis through the surface's own origin."};
  turned.keys = {
      {"about", direction_value(), false, "[0, 0, 1]", "the axis"},
      {"by",
       quantity_value(kAngle, {}, "90 deg"),
       true,
       {},
       "angle, counter-clockwise seen from where the axis points"},
  };
  return {
      {"at", usually(vector_value(kLength, kPlaces, "[0, 0, -20 mm]"), kUsualPlaces), false, "[0, 0, 0]",
       "where the surface's own origin lies; regions are of the surface as it stands there"},
      {"turned", mapping_value({turned}), false, {}, "how it stands there; as it is when absent"},
  };
}

ValueSchema surface_value() {
  ValueSchema unit = quantity_value(kLength, kAboveZero, "mm");
  unit.bare_unit = true;
  MappingSchema mesh{.name = "surface", .documentation = "A surface from a file: OBJ, PLY, STL, glTF and others."};
  mesh.keys = {
      {"mesh", path_value(), true, {}, "file with the stress-free surface"},
      {"unit", unit, false, "m", "length of the file's unit: `mm`, `30 mm`"},
      {"repair", boolean_value(), false, "false",
       "mend what is safe to mend: flaps removed, parts that touch split apart, holes of up to 64 edges filled when "
       "they are not wider than 10 % of the surface"},
      {"remesh",
       quantity_value(kLength, kAboveZero, "1.5 mm"),
       false,
       {},
       "new triangles with edges of about this length; borders and creases above 50 deg stay, the surface moves by at "
       "most half of it; as the file has them when absent"},
  };
  const std::vector<KeySchema> placement = placement_keys();
  mesh.keys.insert(mesh.keys.end(), placement.begin(), placement.end());
  MappingSchema shape{
      .name = "surface",
      .documentation =
          "A shape, centred on its origin. Caps close the fluid and have no stiffness: what presses on one "
          "is borne by its rim, evenly where the rim is free."};
  shape.selector = "shape";
  shape.cases = shape_cases();
  std::vector<std::string> words;
  for (const CaseSchema& row : shape.cases) words.push_back(row.word);
  shape.keys = {
      {"shape", word_value(words), true, {}, "which shape"},
      {"triangles", integer_value(4, 200000, "1280"), false, "1280", "wanted number of wall triangles"},
  };
  shape.keys.insert(shape.keys.end(), placement.begin(), placement.end());
  return mapping_value({mesh, shape});
}

MappingSchema prony_term() {
  MappingSchema term{.name = "viscosity", .documentation = "A part of the stress that fades while the wall is held."};
  term.keys = {
      {"fraction",
       quantity_value(kDimensionless, {.minimum = 0, .maximum = 1, .minimum_excluded = true, .maximum_excluded = true},
                      "0.3"),
       true,
       {},
       "part of the stress at once"},
      {"time", quantity_value(kTime, kAboveZero, "200 ms"), true, {}, "in which it fades to 1/e"},
  };
  return term;
}

MappingSchema damping() {
  MappingSchema damping{.name = "damping", .documentation = "Rayleigh damping of the wall."};
  damping.keys = {
      {"mass_rate", quantity_value(kFrequency, kFromZero, "2 Hz"), false, "0 Hz",
       "factor of the wall's mass: damps slow motion; in dynamic analyses"},
      {"stiffness_time", quantity_value(kTime, kFromZero, "1 ms"), false, "0 s",
       "factor of the stiffness of the unstrained wall: damps fast motion"},
  };
  return damping;
}

ValueSchema wall_value() {
  MappingSchema wall{.name = "wall",
                     .documentation =
                         "The thin wall of a body. It keeps out of its own way: mid-surfaces that come nearer to each "
                         "other than the thickness push each other apart (nearer than 0.4 of the mean edge length of "
                         "the mesh, or than half of their stress-free distance, where those are smaller)."};
  wall.keys = {
      {"model", word_value({"membrane", "shell"}), false, "membrane",
       "membrane: no bending stiffness; shell: bending stiffness of the same material and thickness about the given "
       "shape"},
      {"thickness",
       field_schema(usually(quantity_value(kLength, kAboveZero), kUsualLengths)),
       true,
       {},
       "thickness of the stress-free wall"},
      {"density", usually(quantity_value(kDensity, kAboveZero, "1060 kg/m^3"), kUsualDensities), false, "1060 kg/m^3",
       "density of the wall"},
      {"material", material_schema(), true, {}, "law and constants"},
      {"fibres", fibres_schema(), false, {}, "direction of the fibres; `fung` and `holzapfel` need it"},
      {"tension_field", boolean_value(), false, "false",
       "membrane: where the wall would be compressed it wrinkles finely instead and bears tension only; so does one "
       "that is cut, from then on, unless it is flat and `fixed` keeps all of it in its plane; in a quasi-static "
       "analysis what nothing pulls stays where it was, as if held by 1e-5 of the wall's stiffness"},
      {"prestretch", prestretch_schema(), false, "1",
       "in-plane stretch of the given surface: each triangle's rest shape is the given one shrunk by it"},
  };
  wall.keys.push_back(
      {"toughness",
       field_schema(usually(quantity_value(kForcePerLength, kAboveZero, "0.4 kJ/m^2"), kUsualToughness)),
       false,
       {},
       "energy per new cut area, which is thickness times length of the cut on the given surface, also where "
       "that has a `prestretch`; where a tense wall releases more, cuts run ahead of the blade; a wall without it "
       "cannot be cut or pierced"});
  wall.keys.push_back({"viscosity", list_value(mapping_value({prony_term()})), false, "[]",
                       "Prony series of quasi-linear viscoelasticity; the fractions add up to less than 1"});
  wall.keys.push_back({"damping", mapping_value({damping()}), false, "{}", "Rayleigh damping"});
  return mapping_value({wall});
}

MappingSchema chamber() {
  MappingSchema chamber{.name = "chamber", .documentation = "A closed part of the surface with fluid of its own."};
  chamber.keys = {
      {"at", vector_value(kLength, {}, "[0, 0, 10 mm]"), true, {}, "a point in it, of the stress-free shape"},
      {"pressure",
       quantity_value(kPressure, kFluidPressures, "2 kPa"),
       false,
       {},
       "as that of the contents, which it stands for when absent"},
  };
  return chamber;
}

ValueSchema discharge_value() {
  return quantity_value(kDimensionless, {.minimum = 0, .maximum = 1, .minimum_excluded = true}, "0.61");
}

ValueSchema chamber_name(const char* example) {
  ValueSchema value = name_value();
  value.example = example;
  return value;
}

MappingSchema orifice() {
  MappingSchema orifice{.name = "orifice", .documentation = "A hole through which two chambers exchange fluid."};
  orifice.keys = {
      {"between", tuple_value({chamber_name("upper"), chamber_name("lower")}), true, {}, "names of the two chambers"},
      {"area", usually(quantity_value(kArea, kAboveZero, "2 mm^2"), kUsualHoles), true, {}, "area of the hole"},
      {"discharge", discharge_value(), false, "0.61",
       "flow over area times the root of twice the pressure's fall over the density"},
  };
  return orifice;
}

ValueSchema contents_value() {
  const KeySchema pressure{"pressure",
                           quantity_value(kPressure, kFluidPressures, "2 kPa"),
                           false,
                           {},
                           "pressure above the surroundings at time zero, at the level of the stress-free chamber's "
                           "centroid; the volume follows. When absent the volume is the surface's and the pressure "
                           "follows"};
  const KeySchema density{"density", usually(quantity_value(kDensity, kAboveZero, "1010 kg/m^3"), kUsualDensities),
                          false, "1010 kg/m^3", "density of the fluid"};
  const KeySchema bulk_modulus{"bulk_modulus", usually(quantity_value(kPressure, kBulkModuli, "2 MPa"), kUsualModuli),
                               false, "2 MPa", "pressure per relative loss of volume"};
  MappingSchema contents{.name = "contents", .documentation = "The fluid that wall and caps enclose."};
  const KeySchema chambers{"chambers", named_value(chamber()), false, "{}",
                           "the closed parts of the surface by name; needed for each where there are several"};
  const KeySchema orifices{"orifices", list_value(mapping_value({orifice()})), false, "[]", "holes between chambers"};
  const KeySchema leaks{"leaks", boolean_value(), false, "true",
                        "whether fluid flows out where the wall is open and air in where it sucks; `false` for a gel, "
                        "which holds together and to the lips"};
  const KeySchema discharge{
      "discharge", discharge_value(), false, "0.61",
      "of openings of the wall: flow over area times the root of twice the pressure over the "
      "density, seen from lips at rest; lips that draw back over the fluid let it out as they go"};
  contents.selector = "fluid";
  contents.cases = {
      {"none", "no fluid: an open surface", {}},
      {"incompressible", "the volume is kept", {pressure, density, leaks, discharge, chambers, orifices}},
      {"compressible",
       "the pressure grows with the loss of volume",
       {pressure, density, bulk_modulus, leaks, discharge, chambers, orifices}},
  };
  contents.keys = {
      {"fluid", word_value({"none", "incompressible", "compressible"}), false, "incompressible", "kind of the fluid"}};
  return mapping_value({contents});
}

ValueSchema fixed_value() {
  MappingSchema fixed{.name = "fixed",
                      .documentation =
                          "Vertices that keep their stress-free positions. A flat cap that is held along its normal is "
                          "a floor: the wall does not pass its plane, where all of it lies on one side. A tool that is "
                          "pressed against what cannot give way along its way ends the run; needles that pierce and "
                          "blades that incise go through."};
  fixed.keys = {
      {"region", region_schema(), true, {}, "which vertices"},
      {"axes", {.kind = ValueKind::kAxes}, false, "xyz", "along which axes"},
      {"clamped", boolean_value(), false, "false",
       "shell: across open edges within the region the wall keeps its direction, as in a clamp or at a plane of "
       "symmetry; "
       "otherwise they are hinges"},
  };
  return list_value(mapping_value({fixed}));
}

MappingSchema one_key_region(const std::string& key, ValueSchema value, const std::string& documentation) {
  return {.name = "region", .documentation = documentation, .keys = {{key, std::move(value), true, {}, documentation}}};
}

ValueSchema half_space(const std::string& name, const std::string& documentation) {
  MappingSchema part{.name = name, .documentation = documentation};
  part.keys = {
      {"axis", word_value({"x", "y", "z"}), true, {}, "axis that is measured along"},
      {"at", quantity_value(kLength, {}, "5 mm"), true, {}, "coordinate on it"},
  };
  return mapping_value({part});
}

}  // namespace

ValueSchema region_schema() {
  ValueSchema plane = half_space("plane", "To either side of a plane.");
  plane.mappings[0].keys.push_back(
      {"within", quantity_value(kLength, kFromZero, "0.1 mm"), false, "0.001 mm", "distance to either side"});
  MappingSchema box{.name = "box", .documentation = "An upright box."};
  box.keys = {{"min", vector_value(kLength, {}, "[0, 0, 10 mm]"), true, {}, "lowest corner"},
              {"max", vector_value(kLength, {}, "[5 mm, 5 mm, 20 mm]"), true, {}, "highest corner"}};
  MappingSchema ball{.name = "sphere", .documentation = "A ball."};
  ball.keys = {{"center", vector_value(kLength, {}, "[0, 0, 20 mm]"), true, {}, "middle"},
               {"radius", quantity_value(kLength, kAboveZero, "5 mm"), true, {}, "radius"}};
  ValueSchema boundary = word_value({"true"}), all = boundary;
  return mapping_value({
      one_key_region("group", text_value(),
                     "a group of vertices, as the surface's file names it, or of a shape: `base`, `ends`, `wall`"),
      one_key_region("plane", plane, "near a plane"),
      one_key_region("below", half_space("below", "Where the coordinate is at most `at`."), "below a plane"),
      one_key_region("above", half_space("above", "Where the coordinate is at least `at`."), "above a plane"),
      one_key_region("box", mapping_value({box}), "in a box"),
      one_key_region("sphere", mapping_value({ball}), "in a ball"),
      one_key_region("boundary", boundary, "the open edges of the wall, capped or not"),
      one_key_region("all", all,
                     "the whole wall: a body that is fixed so is scenery, in which others lie in pictures, and which "
                     "is meant only where it is named"),
  });
}

ValueSchema bodies_schema() {
  MappingSchema body{
      .name = "body",
      .documentation = "A thin wall and what it encloses. Tools press on bodies; bodies do not feel each other."};
  body.keys = {
      {"surface", surface_value(), true, {}, "the stress-free surface"},
      {"wall", wall_value(), true, {}, "the wall"},
      {"contents", contents_value(), false, "{}", "the fluid inside"},
      {"fixed", fixed_value(), false, "[]", "what is held in place"},
      {"loads", loads_schema(), false, "[]", "what else pulls and presses"},
  };
  return named_value(std::move(body), 1);
}

}  // namespace thinwall
