// What check tells, and with which exit code.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/studio/commands/ProgramFixture.hpp"

namespace thinwall {
namespace {

TEST_F(ProgramTest, CheckTellsOfThickWallsAndAStillOfLettersThatTheFontHasNot) {
  std::string text = small_scenario();
  text.replace(text.find("thickness: 1 mm"), 15, "thickness: 21 mm");
  text.replace(text.find("A small hemisphere"), 18, "\u16a0");
  write_bytes(folder_ / "thick.yaml", text);
  const std::string checked = run({"check", "thick.yaml"}).messages;
  EXPECT_NE(checked.find("thick.yaml: note: body `organ` is 20 mm wide, less than two walls of 21 mm"),
            std::string::npos)
      << checked;
  const std::string still = run({"still", "thick.yaml", "--at", "0s", "-o", "a.png", "--device", "99"}).messages;
  EXPECT_NE(still.find("the font of pictures has no shape for"), std::string::npos) << still;
}

TEST_F(ProgramTest, CheckTellsWhereItIsNotKnownWhatClipsMeetAndGoesOn) {
  write_bytes(folder_ / "bursts.yaml",
              "thinwall: 1\n"
              "bodies:\n"
              "  ball:\n"
              "    surface: { shape: sphere, radius: 20 mm, triangles: 20 }\n"
              "    wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 20 kPa } }\n"
              "    contents: { pressure: 50 kPa }\n"
              "timeline:\n"
              "  - drain: { body: ball, by: 1 ml, for: 1 s }\n");
  const ProgramEnd end = run({"check", "bursts.yaml", "small.yaml"});
  EXPECT_EQ(end.exit_code, 0) << end.messages;
  EXPECT_NE(end.messages.find(
                "bursts.yaml: note: its run will fail, so what its clips meet or drain is not known: body `ball`"),
            std::string::npos)
      << end.messages;
  EXPECT_NE(end.messages.find("small.yaml: good"), std::string::npos) << end.messages;
}

TEST_F(ProgramTest, CheckTellsAllMistakesAsJson) {
  write_bytes(folder_ / "bad.yaml", "thinwall: 1\nbodys: {}\n");
  const ProgramEnd end = run({"check", "--json", "small.yaml", "bad.yaml"});
  EXPECT_EQ(end.exit_code, 2);
  const nlohmann::json result = nlohmann::json::parse(end.output);
  EXPECT_EQ(result.value("exit_code", -1), 2);
  EXPECT_EQ(result["scenarios"][0]["good"], true);
  EXPECT_FALSE(result["scenarios"][0]["notes"].empty()) << "of the surface that was made";
  EXPECT_EQ(result["scenarios"][1]["good"], false);
  EXPECT_EQ(result["scenarios"][1]["errors"][0]["file"], "bad.yaml");
  const nlohmann::json& errors = result["scenarios"][1]["errors"];
  EXPECT_TRUE(std::any_of(errors.begin(), errors.end(), [](const auto& error) { return error["line"] == 2; }))
      << errors;
}

TEST_F(ProgramTest, WhatCheckWarnsOfARunTellsAndKeepsToo) {
  std::string scenario = file_bytes(folder_ / "small.yaml");
  const std::string tools = "tools:\n";
  ASSERT_NE(scenario.find(tools), std::string::npos) << scenario;
  scenario.replace(scenario.find(tools), tools.size(), tools + "  spare: { kind: sphere }\n");
  write_bytes(folder_ / "spare.yaml", scenario);
  const std::string warning = "warning: tools.spare: no clip uses this tool";
  const ProgramEnd checked = run({"check", "spare.yaml"});
  EXPECT_NE(checked.messages.find(warning), std::string::npos) << checked.messages;
  const ProgramEnd end = run({"run", "spare.yaml", "--no-render", "--json"});
  EXPECT_EQ(end.exit_code, 0);
  EXPECT_NE(end.messages.find(warning), std::string::npos) << end.messages;
  EXPECT_NE(nlohmann::json::parse(end.output).at("warnings").dump().find(warning), std::string::npos) << end.output;
  EXPECT_NE(manifest("out/spare").at("warnings").dump().find(warning), std::string::npos);
}

/// A scenario of a second in which much is to happen at 50 s, and a place is 30 m off.
std::string with_late_times() {
  return small_scenario("  - wait: { for: 1 s }\n") +
         "cameras: { near: { position: [0, -80 mm, 60 mm] } }\n"
         "cuts: [ { at: 50 s, camera: near } ]\n"
         "teaching:\n"
         "  freezes: [ { at: 50 s, for: 1 s } ]\n"
         "  slow_motion: [ { from: 50 s, until: 51 s, speed: 0.5 } ]\n"
         "  labels:\n"
         "    - { text: late, body: organ, at: [0, 0, 20 mm], from: 50 s }\n"
         "    - { text: far, body: organ, at: [0, 0, 30 m] }\n";
}

TEST_F(ProgramTest, CheckNotesTimesAfterTheEndAndFarPlacesAsARunDoes) {
  write_bytes(folder_ / "late.yaml", with_late_times());
  const ProgramEnd checked = run({"check", "late.yaml", "--json"});
  EXPECT_EQ(checked.exit_code, 0) << checked.messages;
  const nlohmann::json notes = nlohmann::json::parse(checked.output)["scenarios"][0]["notes"];
  const nlohmann::json told = nlohmann::json::parse(run({"run", "late.yaml", "--no-render", "--json"}).output);
  for (const char* path : {"cuts[1].at: 50 s is after the end of the run", "teaching.freezes[1].at: 50 s",
                           "teaching.slow_motion[1].from: 50 s", "teaching.labels[1].from: 50 s",
                           "teaching.labels[2].at: it lies 2.998e+04 mm off"}) {
    const auto has = [&](const nlohmann::json& list) {
      return std::ranges::any_of(list, [&](const std::string& note) { return note.starts_with(path); });
    };
    EXPECT_TRUE(has(notes)) << path << "\n" << notes;
    EXPECT_TRUE(has(told.at("warnings"))) << path << "\n" << told.at("warnings");
    EXPECT_NE(checked.messages.find("late.yaml: note: " + std::string(path)), std::string::npos);
  }
}

TEST_F(ProgramTest, CheckRefusesWhatARunRefusesAlsoWhereNoClipTouchesAWall) {
  write_bytes(folder_ / "open.yaml",
              "thinwall: 1\n"
              "bodies:\n"
              "  organ:\n"
              "    surface: { shape: hemisphere, radius: 20 mm, triangles: 64 }\n"
              "    wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 20 kPa } }\n"
              "    contents: { fluid: none }\n"
              "timeline: [ { inflate: { body: organ, by: 5 ml, for: 2 s } } ]\n");
  for (const std::string command : {"check", "run"}) {
    expect_bad_usage({command, "open.yaml"}, "timeline[1].inflate: the body `organ` holds no fluid");
  }
}

TEST_F(ProgramTest, ACameraThatCanLookNowhereIsBadInputWithItsPlace) {
  std::string text = small_scenario() + "cameras: { inner: { position: [0, 0, 10 mm] } }\n";  // of a box 20 mm high
  write_bytes(folder_ / "blind.yaml", text);
  for (const std::vector<std::string>& command : {std::vector<std::string>{"check", "blind.yaml"},
                                                  {"run", "blind.yaml", "--no-render"},
                                                  {"still", "blind.yaml", "--at", "0s", "-o", "a.png"}}) {
    const ProgramEnd end = run(command);
    if (end.exit_code == 4) continue;  // there is no device that a still could be drawn with
    EXPECT_EQ(end.exit_code, 2) << end.messages;
    EXPECT_NE(
        end.messages.find("blind.yaml:16:31: error: cameras.inner.position: the camera stands in the middle of the "
                          "bodies, where it looks without `target`; give it a `target`"),
        std::string::npos)
        << end.messages;
  }
}

TEST_F(ProgramTest, AKeyframeThatCanLookNowhereIsBadInputWithItsPlaceToo) {
  const std::string keyframes =
      "camera:\n  keyframes:\n    - { at: 0 s, position: [90 mm, 0, 10 mm] }\n    - { at: 1 s, position: ";
  write_bytes(folder_ / "blind.yaml", small_scenario() + keyframes + "[0, 0, 10 mm] }\n");
  expect_bad_usage({"check", "blind.yaml"},
                   "blind.yaml:19:28: error: camera.keyframes[2].position: the camera stands in the middle of the "
                   "bodies, where it looks without `target`; give it a `target`");
  // One that follows a tool looks at that.
  write_bytes(folder_ / "follows.yaml", small_scenario() + keyframes + "[0, 0, 10 mm] }\n  follow: { tool: probe }\n");
  EXPECT_EQ(run({"check", "follows.yaml"}).exit_code, 0);
  write_bytes(folder_ / "within.yaml", small_scenario() + keyframes + "[0, 0, 8 mm] }\n");
  const ProgramEnd end = run({"check", "within.yaml"});
  EXPECT_EQ(end.exit_code, 0) << end.messages;
  EXPECT_NE(end.messages.find("camera.keyframes[2].position: the camera stands within body `organ`"), std::string::npos)
      << end.messages;
}

TEST_F(ProgramTest, ACameraWithinABodyIsNotedUnlessItIsAnEndoscope) {
  const auto messages_with = [&](const std::string& camera) {
    write_bytes(folder_ / "within.yaml", small_scenario() + "camera: { " + camera + " }\n");
    const ProgramEnd end = run({"check", "within.yaml"});
    EXPECT_EQ(end.exit_code, 0) << end.messages;
    return end.messages;
  };
  const std::string words = "camera.position: the camera stands within body `organ` and sees its lining";
  EXPECT_NE(messages_with("position: [3 mm, 0, 8 mm]").find(words), std::string::npos);
  EXPECT_EQ(messages_with("position: [3 mm, -80 mm, 60 mm]").find(words), std::string::npos);
  EXPECT_EQ(messages_with("kind: endoscope, position: [3 mm, 0, 8 mm]").find(words), std::string::npos);
}

TEST_F(ProgramTest, CheckTellsOfASecondTakeThatGoesOnAfterTheFirst) {
  const auto messages_with = [&](const std::string& speed) {
    write_bytes(folder_ / "compared.yaml", small_scenario() + "comparison:\n  set: { \"timeline[1].palpate.speed\": " +
                                               speed + " }\n  captions: [a, b]\n");
    return run({"check", "compared.yaml"}).messages;
  };
  EXPECT_NE(messages_with("10 mm/s").find("note: the second take lasts "), std::string::npos);
  EXPECT_EQ(messages_with("40 mm/s").find("the second take lasts"), std::string::npos) << "it waits for the first";
}

}  // namespace
}  // namespace thinwall
