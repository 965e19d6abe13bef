#include "studio/scenario/UnitPass.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/studio/scenario/ScenarioTestTools.hpp"
#include "tests/studio/schema/SchemaForms.hpp"

namespace thinwall {
namespace {

const MappingSchema& mapping_named(const std::string& name) {
  for (const SchemaForm& form : all_schema_forms()) {
    if (form.mapping->name == name) return *form.mapping;
  }
  throw std::out_of_range(name);
}

struct Read {
  CheckedValue value;
  std::vector<std::string> errors;
  std::vector<std::string> warnings;
};

Read read(const std::string& mapping, const std::string& text) {
  Diagnostics diagnostics;
  Read result{unit_pass(parse_text(text, diagnostics), mapping_named(mapping), diagnostics), {}, {}};
  result.errors = short_texts(diagnostics.errors);
  result.warnings = short_texts(diagnostics.warnings);
  return result;
}

using Texts = std::vector<std::string>;

TEST(UnitPass, QuantitiesBecomeSiNumbers) {
  const Read wall = read("wall", "{ thickness: 0.8 mm, material: { law: neo_hookean, shear_modulus: 12 kPa } }");
  EXPECT_EQ(wall.value.at("thickness").number, 0.0008);
  EXPECT_EQ(wall.value.at("material").at("shear_modulus").number, 12000);
  EXPECT_EQ(wall.errors, Texts{});
}

TEST(UnitPass, DefaultsAreFilledInAndMarked) {
  const Read wall = read("wall", "{ thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 12 kPa } }");
  EXPECT_EQ(wall.value.at("density").number, 1060);
  EXPECT_FALSE(wall.value.at("density").given);
  EXPECT_TRUE(wall.value.at("thickness").given);
}

TEST(UnitPass, ZeroNeedsNoUnitAndPointsMixBoth) {
  const Read clip = read("palpate", "{ at: [0, -5 mm, 2 cm], depth: 1 mm, hold: 0 }");
  EXPECT_EQ(clip.value.at("at").items[1].number, -0.005);
  EXPECT_EQ(clip.value.at("at").items[2].number, 0.02);
  EXPECT_EQ(clip.errors, Texts{});
  EXPECT_FALSE(std::signbit(read("palpate", "{ at: [-0, 0, 0], depth: 1 mm }").value.at("at").items[0].number));
}

TEST(UnitPass, AGroupIsNamedAsItsFileNamesItAlsoWhereThatIsNoNameOfOurs) {
  for (const std::string group : {"Cube.001", "meshes[0]", "liver bed", "1"}) {
    const Read fixed = read("fixed", "{ region: { group: \"" + group + "\" } }");
    ASSERT_EQ(fixed.errors, Texts{});
    EXPECT_EQ(fixed.value.at("region").at("group").text, group);
  }
}

TEST(UnitPass, AMagnitudeBeyondWhatIsUsualIsAllowedAndToldOf) {
  const Read blade = read("tool", "{ kind: scalpel, thickness: 1e-160 mm }");
  EXPECT_EQ(blade.errors, Texts{});
  EXPECT_EQ(blade.value.at("thickness").number, 1e-163);
  EXPECT_EQ(blade.warnings,
            Texts{"1:29: thickness: 1e-160 mm is unusual: thicknesses of blades, plates and jaws are from 0.001 mm to "
                  "100 mm as a rule; see whether number and unit are meant so"});
  EXPECT_EQ(read("tool", "{ kind: sphere, radius: 6 m }").warnings.size(), 1U);
  EXPECT_EQ(read("tool", "{ kind: plate, size: [20 mm, 30 m] }").warnings.size(), 1U);
  EXPECT_EQ(read("palpate", "{ depth: 6 mm, speed: 20 m/s }").warnings.size(), 1U);
  EXPECT_EQ(read("orifice", "{ between: [a, b], area: 2 m^2 }").warnings.size(), 1U);
  EXPECT_EQ(read("material", "{ law: neo_hookean, shear_modulus: 20 mPa }").warnings.size(), 1U);
  EXPECT_EQ(read("simulation", "{ gravity: [0, 0, -9.81 km/s^2] }").warnings.size(), 1U);
}

TEST(UnitPass, APrestretchThatIsMeantAsAStrainIsToldOf) {
  const std::string wall = "{ thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 12 kPa }, prestretch: ";
  EXPECT_EQ(read("wall", wall + "15 % }").warnings.size(), 1U);
  EXPECT_EQ(read("wall", wall + "{ along: [1, 0, 0], values: [1.1, 0.1] } }").warnings.size(), 1U);
  EXPECT_EQ(read("wall", wall + "1.15 }").warnings, Texts{});
}

TEST(UnitPass, WhatIsUsualOrNoneIsNotToldOf) {
  EXPECT_EQ(read("palpate", "{ depth: 6 mm, speed: 20 mm/s, hold: 0, standoff: 5 mm }").warnings, Texts{});
  EXPECT_EQ(read("tool", "{ kind: needle, radius: 0.1 mm, length: 300 mm, friction: 1.2 }").warnings, Texts{});
  EXPECT_EQ(read("simulation", "{ gravity: [0, 0, -9.81 m/s^2] }").warnings, Texts{}) << "magnitudes are judged";
}

TEST(UnitPass, ZeroInAnotherUnitIsStillOfAnotherDimension) {
  EXPECT_EQ(read("palpate", "{ hold: 0 mm, depth: 1 mm }").errors,
            Texts{"1:9: hold: expected a time (e.g. 0.5 s), got 0 mm, a length"});
}

TEST(UnitPass, DirectionsBecomeUnitVectorsWhateverTheirSize) {
  for (const std::string text : {"[3, 0, 4]", "[3e-300, 0, 4e-300]", "[3e300, 0, 4e300]"}) {
    const Read clip = read("palpate", "{ depth: 1 mm, direction: " + text + " }");
    EXPECT_DOUBLE_EQ(clip.value.at("direction").items[0].number, 0.6) << text;
    EXPECT_DOUBLE_EQ(clip.value.at("direction").items[2].number, 0.8) << text;
  }
}

TEST(UnitPass, TheUnitOfAMeshIsAUnitOrALength) {
  const auto unit = [](const std::string& text) {
    Diagnostics diagnostics;
    for (const SchemaForm& form : all_schema_forms()) {
      if (form.mapping->keys[0].key != "mesh") continue;
      const TextNode node = parse_text("{ mesh: a.obj, unit: " + text + " }", diagnostics);
      const CheckedValue value = unit_pass(node, *form.mapping, diagnostics);
      return diagnostics.errors.empty() ? value.at("unit").number : -1;
    }
    return -2.0;
  };
  EXPECT_EQ(unit("mm"), 0.001);
  EXPECT_EQ(unit("30 mm"), 0.03);
  EXPECT_EQ(unit("\"1 in\""), -1);
  EXPECT_EQ(unit("s"), -1);
  EXPECT_EQ(unit("30"), -1);
  EXPECT_EQ(unit("0 mm"), -1);
}

TEST(UnitPass, PathsCountFromTheFileThatNamesThem) {
  Diagnostics diagnostics;
  const TextNode node = *read_yaml_text("{ mesh: ../organs/a.obj }", "scenes/liver/main.yaml", diagnostics);
  for (const SchemaForm& form : all_schema_forms()) {
    if (form.mapping->keys[0].key != "mesh") continue;
    EXPECT_EQ(unit_pass(node, *form.mapping, diagnostics).at("mesh").text, "scenes/organs/a.obj");
  }
}

TEST(UnitPass, AxesAreSortedAndEachIsThereOnce) {
  EXPECT_EQ(read("fixed", "{ region: { boundary: true }, axes: zx }").value.at("axes").text, "xz");
  EXPECT_EQ(read("fixed", "{ region: { boundary: true }, axes: xx }").errors.size(), 1U);
  EXPECT_EQ(read("fixed", "{ region: { boundary: true }, axes: w }").errors.size(), 1U);
}

TEST(UnitPass, AKeyOfAnotherCaseSaysWhereItBelongs) {
  EXPECT_EQ(read("tool", "{ kind: line, radius: 3 mm }").errors,
            Texts{"1:15: radius: unknown key for `kind: line`, it belongs to `point`, `sphere`, `capsule`, `needle`"});
  EXPECT_EQ(read("contents", "{ bulk_modulus: 2 MPa }").errors,
            Texts{"1:3: bulk_modulus: unknown key for `fluid: incompressible`, it belongs to `compressible`"});
}

TEST(UnitPass, AFluidIsNoStifferThanAWallMayBe) {
  EXPECT_EQ(read("contents", "{ fluid: compressible, bulk_modulus: 1e7 MPa }").errors, Texts{});
  EXPECT_EQ(read("contents", "{ fluid: compressible, bulk_modulus: 1e8 MPa }").errors,
            Texts{"1:38: bulk_modulus: 1e8 MPa is out of range, it must be greater than 0 MPa and at most 1e+07 MPa"});
}

TEST(UnitPass, NoStepIsAskedForWithLessErrorThanCoordinatesCanTell) {
  EXPECT_EQ(read("simulation", "{ step_error: 1e-6 mm }").errors, Texts{});
  EXPECT_EQ(read("simulation", "{ step_error: 1e-7 mm }").errors,
            Texts{"1:15: step_error: 1e-7 mm is out of range, it must be at least 1e-06 mm"});
}

TEST(UnitPass, AlternativesWithoutTheKeyThatTellsThemApartSayWhatIsMissing) {
  const std::string head = "{ surface: { shape: sphere }, wall: { thickness: 1 mm, material: { law: neo_hookean, ";
  const Read without = read("body", head + "shear_modulus: 1 kPa } }, loads: [ { region: { group: wall } } ] }");
  EXPECT_EQ(without.errors, Texts{"1:121: loads[1]: one of `pressure`, `force`, `line_force`, `moment`, `traction`, "
                                  "`body_force` is missing"});
  const Read mistyped =
      read("body", head + "shear_modulus: 1 kPa } }, loads: [ { region: { group: wall }, presure: 0 } ] }");
  EXPECT_EQ(mistyped.errors, Texts{"1:148: loads[1].presure: unknown key, did you mean `pressure`?"});
}

TEST(UnitPass, ANameThatIsTooLongSaysHowLongItMayBe) {
  const std::string body =
      ": { surface: { shape: sphere }, wall: { thickness: 1 mm, material: { law: neo_hookean, "
      "shear_modulus: 1 kPa } } } } }";
  const std::string head = "{ thinwall: 1, bodies: { ";
  EXPECT_EQ(read("scenario", head + std::string(64, 'b') + body).errors, Texts{});
  const Read longer = read("scenario", head + std::string(65, 'b') + body);
  ASSERT_EQ(longer.errors.size(), 1U);
  EXPECT_TRUE(longer.errors[0].ends_with("a name has at most 64 characters, this one has 65")) << longer.errors[0];
}

TEST(UnitPass, ATextThatNoTakeHasRoomForSaysHowLongItMayBe) {
  const std::string body =
      ", bodies: { ball: { surface: { shape: sphere }, wall: { thickness: 1 mm, material: { law: neo_hookean, "
      "shear_modulus: 1 kPa } } } } }";
  const std::string head = "{ thinwall: 1, title: ";
  EXPECT_EQ(read("scenario", head + std::string(10000, 't') + body).errors, Texts{});
  EXPECT_EQ(read("scenario", head + std::string(10001, 't') + body).errors,
            Texts{"1:23: title: expected a text, got one of 10001 bytes; a text has at most 10000"});
}

TEST(UnitPass, ATextWhoseEndIsTakenForACommentIsToldOfAndAQuantityIsNot) {
  const Read clip = read("wait", "for: 1 s #short\ncaption: Press #1 gently\nchapter: First # of two\n");
  EXPECT_EQ(clip.errors, Texts{});
  EXPECT_EQ(clip.warnings,
            Texts{"2:10: caption: `#1 gently` is taken for a comment, so that the text is `Press`; a text with ` #` in "
                  "it needs quotation marks around it"});
}

TEST(UnitPass, AWrongWordIsOneErrorAndItsKeysAreNotJudged) {
  EXPECT_EQ(read("material", "{ law: neo_hokean, shear_modulus: 20 kPa }").errors.size(), 1U);
}

TEST(UnitPass, AKeyInTheWrongPlaceSaysWhereItBelongs) {
  const Read body = read("body",
                         "{ surface: { shape: sphere }, thickness: 1 mm, wall: { thickness: 1 mm, "
                         "material: { law: neo_hookean, shear_modulus: 1 kPa } } }");
  EXPECT_EQ(body.errors, Texts{"1:31: thickness: unknown key, it belongs inside `wall`"});
}

TEST(UnitPass, AMisspelledNeededKeyIsOneError) {
  EXPECT_EQ(read("palpate", "{ dept: 4 mm }").errors, Texts{"1:3: dept: unknown key, did you mean `depth`?"});
}

TEST(UnitPass, AKeyWithoutSpaceBehindItsColonIsOneErrorThatSaysSo) {
  EXPECT_EQ(read("palpate", "{depth:2 mm, speed: 3 mm/s}").errors,
            Texts{"1:2: `depth:2 mm`: unknown key, a space is needed behind `depth:`"});
  const std::string body =
      "thinwall: 1\nbodies: { ball: { surface: { shape: sphere }, wall: { thickness: 1 mm, material: { law: "
      "neo_hookean, shear_modulus: 1 kPa } } } }\ntimeline:\n  - ";
  EXPECT_EQ(read("scenario", body + "wait:{for: 2 s}").errors,
            Texts{"4:5: timeline[1].`wait:{for`: unknown key, a space is needed behind `wait:`"});
  EXPECT_EQ(read("scenario", body + "wait:\n      for:2 s").errors,
            Texts{"5:7: timeline[1].wait: expected a mapping, got `for:2 s`: a key is followed by `:` and a space"});
}

TEST(UnitPass, WrongItemsKeepTheirPlaceInAList) {
  const Read root = read("scenario", "{ timeline: [ { jump: {} }, { wait: {} } ] }");
  EXPECT_EQ(root.value.at("timeline").items.size(), 2U);
  EXPECT_TRUE(root.value.at("timeline").items[0].members.empty());
}

TEST(UnitPass, AnErrorInAParameterSaysWhatItWas) {
  Diagnostics diagnostics;
  TextNode node = parse_text("{ depth: 4 kg }", diagnostics);
  node.find("depth")->value.parameters = "`${d}` is `4 kg`";
  unit_pass(node, mapping_named("palpate"), diagnostics);
  EXPECT_EQ(short_texts(diagnostics.errors),
            Texts{"1:10: depth: expected a length (e.g. 4 mm), got 4 kg, a mass (`${d}` is `4 kg`)"});
}

}  // namespace
}  // namespace thinwall
