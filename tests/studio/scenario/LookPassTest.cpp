#include "studio/scenario/LookPass.hpp"

#include <gtest/gtest.h>

#include "tests/studio/scenario/CheckedText.hpp"

namespace thinwall {
namespace {

std::string organ(const std::string& look, const std::string& surface = "{ shape: sphere }") {
  CheckedValue root = checked_scenario("look: " + look + "\n", surface);
  look_pass(root);
  return root.at("look").at("bodies").at("organ").at("organ").text;
}

TEST(LookPass, TakesTheOrganFromTheNameOfTheMesh) {
  EXPECT_EQ(organ("{}", "{ mesh: organs/gallbladder_light.obj, unit: mm }"), "gallbladder");
  EXPECT_EQ(organ("{}", "{ mesh: Liver.ply, unit: mm }"), "liver");
}

TEST(LookPass, TakesNoOrganFromTheFolderOfTheMesh) {
  EXPECT_EQ(organ("{}", "{ mesh: stomach/thing.obj, unit: mm }"), "tissue");
}

TEST(LookPass, TakesAnyTissueWhereNoNameSaysMore) {
  EXPECT_EQ(organ("{}"), "tissue");
  EXPECT_EQ(organ("{ bodies: { organ: { wetness: 0.5 } } }"), "tissue");
}

TEST(LookPass, KeepsWhatTheScenarioSays) {
  EXPECT_EQ(organ("{ bodies: { organ: { organ: skin } } }", "{ mesh: liver.obj, unit: mm }"), "skin");
}

TEST(LookPass, TakesTheOrganFromTheNameOfTheBody) {
  Diagnostics ignored;
  CheckedValue root =
      unit_pass(parse_text("thinwall: 1\nbodies:\n  Left_Stomach:\n    surface: { shape: sphere }\n"
                           "    wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 1 kPa } }\n",
                           ignored),
                scenario_schema(), ignored);
  look_pass(root);
  EXPECT_EQ(root.at("look").at("bodies").at("Left_Stomach").at("organ").text, "stomach");
}

double lamp(const std::string& sections) {
  CheckedValue root = checked_scenario(sections);
  look_pass(root);
  return root.at("lights").at("endoscope").number;
}

TEST(LookPass, GivesAnEndoscopeItsLamp) {
  EXPECT_EQ(lamp("camera: { kind: endoscope }\n"), 1);
  EXPECT_EQ(lamp("camera: { kind: pinhole }\n"), 0);
  EXPECT_EQ(lamp("camera: { kind: endoscope }\nlights: { endoscope: 0 }\n"), 0);
  EXPECT_EQ(lamp("lights: { endoscope: 2 }\n"), 2);
}

TEST(LookPass, GivesEachOfSeveralEndoscopesItsLamp) {
  CheckedValue root =
      checked_scenario("cameras: { inside: { kind: endoscope }, dark: { kind: endoscope, lamp: 0 }, outside: {} }\n");
  look_pass(root);
  EXPECT_EQ(root.at("lights").at("endoscope").number, 0) << "the main camera is none";
  EXPECT_EQ(root.at("cameras").at("inside").at("lamp").number, 1);
  EXPECT_EQ(root.at("cameras").at("dark").at("lamp").number, 0);
  EXPECT_EQ(root.at("cameras").at("outside").at("lamp").number, 0);
  CheckedValue lit = checked_scenario("lights: { endoscope: 2 }\ncameras: { inside: { kind: endoscope } }\n");
  look_pass(lit);
  EXPECT_EQ(lit.at("cameras").at("inside").find("lamp"), nullptr) << "the lights' own counts";
}

}  // namespace
}  // namespace thinwall
