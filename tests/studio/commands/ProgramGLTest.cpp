#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/video/VideoProbe.hpp"
#include "tests/studio/commands/ProgramGLFixture.hpp"

namespace thinwall {
namespace {

TEST_F(ProgramGLTest, ARunLeavesEachFileOfTheContract) {
  expect_good({"run", "scenes/small.yaml", "--frames", "--surfaces"});
  const nlohmann::json manifest = this->manifest("out/small");
  EXPECT_EQ(manifest["files"],
            nlohmann::json({"forces.csv", "body.csv", "take.h5", "video.mp4", "captions.vtt", "poster.png",
                            "contact_sheet.png", "forces.png", "energies.png", "frames", "surfaces"}));
  const std::size_t frames = manifest["frame_hashes"].size();
  EXPECT_EQ(manifest["frames"], frames);
  EXPECT_GT(frames, 5U);
  EXPECT_EQ(probe_video(folder_ / "out/small/video.mp4").frames, static_cast<std::int64_t>(frames));
  EXPECT_FALSE(manifest["driver"].get<std::string>().empty());
  EXPECT_EQ(image_hash(read_png(folder_ / "out/small/frames/frame_000003.png")), manifest["frame_hashes"][3]);
}

TEST_F(ProgramGLTest, TwoRunsHaveTheSameFrameHashes) {
  expect_good({"run", "scenes/small.yaml", "--no-video", "--out", "one"});
  expect_good({"run", "scenes/small.yaml", "--no-video", "--out", "two"});
  EXPECT_EQ(manifest("one")["frame_hashes"], manifest("two")["frame_hashes"]);
}

TEST_F(ProgramGLTest, TheTakeGivesTheFramesOfTheRunAgain) {
  expect_good({"run", "scenes/small.yaml", "--no-video", "--out", "run"});
  expect_good({"render", "run/take.h5", "--no-video"});
  EXPECT_EQ(manifest("run/render")["frame_hashes"], manifest("run")["frame_hashes"]);
  EXPECT_EQ(run({"render", "run/take.h5", "--out", "run"}).exit_code, 2);
}

TEST_F(ProgramGLTest, OfATakeThatEndsEarlyThePicturesAreMadeAndItIsSaidThatTheyEndEarly) {
  write_bytes(folder_ / "scenes" / "long.yaml", small_scenario("  - wait: { for: 1000 s }\n"));
  ASSERT_EQ(run_stopped_midway(folder_.path(), "scenes/long.yaml", SIGTERM).exit_code, 143);
  const ProgramEnd end = run({"render", "out/take.unfinished.h5", "--no-video", "--out", "again"});
  EXPECT_EQ(end.exit_code, 0) << end.messages;
  EXPECT_NE(end.messages.find("note: the take out/take.unfinished.h5 ends early, at "), std::string::npos)
      << end.messages;
  EXPECT_EQ(manifest("again")["complete"], false);
  EXPECT_EQ(manifest("again")["result"], "the take ends early");
  EXPECT_EQ(manifest("again")["warnings"].size(), 1U);
}

TEST_F(ProgramGLTest, TwoTakesBesideOneAnotherAreTheSameInARunFromTheirTakesAndAsAStill) {
  write_bytes(folder_ / "two.yaml", small_scenario() + "comparison: { set: { depth: 4 mm }, captions: [two, four] }\n");
  expect_good({"run", "two.yaml", "--no-video", "--out", "run"});
  EXPECT_EQ(manifest("run")["files"].back(), "second_take");
  expect_good({"render", "run/take.h5", "--no-video"});
  EXPECT_EQ(manifest("run/render")["frame_hashes"], manifest("run")["frame_hashes"]);
  expect_good({"still", "two.yaml", "--at", "0.12 s", "-o", "still.png"});
  EXPECT_EQ(image_hash(read_png(folder_ / "still.png")), manifest("run")["frame_hashes"][3]);
  expect_good({"run", "two.yaml", "--no-video", "--set", "depth=4mm", "--out", "equal"});
  EXPECT_NE(manifest("equal")["frame_hashes"], manifest("run")["frame_hashes"]);
  EXPECT_EQ(file_bytes(folder_ / "equal/second_take/forces.csv"), file_bytes(folder_ / "run/second_take/forces.csv"));
  EXPECT_EQ(file_bytes(folder_ / "equal/forces.csv"), file_bytes(folder_ / "run/second_take/forces.csv"));
  EXPECT_EQ(run({"run", "two.yaml", "--aov"}).exit_code, 2);
  const ProgramEnd alone = run({"render", "run/second_take/take.h5", "--no-video", "--out", "alone"});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_NE(alone.messages.find("the second take of a comparison; name the first, run/take.h5"), std::string::npos)
      << alone.messages;
  std::filesystem::remove_all(folder_ / "run/second_take");
  const ProgramEnd end = run({"render", "run/take.h5", "--no-video", "--out", "half"});
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_NE(end.messages.find("second_take/take.h5, which is not there"), std::string::npos) << end.messages;
}

TEST_F(ProgramGLTest, ATakeGivesTheLessonOfTheRunAgainAlsoInAnotherView) {
  const std::string view = small_scenario();
  write_bytes(folder_ / "view.yaml", view);
  write_bytes(
      folder_ / "lesson.yaml",
      view + "teaching: { labels: [ { text: Crown, at: [0, 0, 25 mm] } ], freezes: [ { at: 60 ms, for: 200 ms } ] }\n");
  expect_good({"run", "lesson.yaml", "--no-video", "--out", "run"});
  expect_good({"render", "run/take.h5", "--no-video", "--out", "again"});
  expect_good({"render", "run/take.h5", "--no-video", "--view", "view.yaml", "--out", "viewed"});
  expect_good({"run", "view.yaml", "--no-video", "--out", "bare"});
  EXPECT_EQ(manifest("again")["frame_hashes"], manifest("run")["frame_hashes"]);
  EXPECT_EQ(manifest("viewed")["frame_hashes"], manifest("run")["frame_hashes"]);
  EXPECT_NE(manifest("bare")["frame_hashes"], manifest("run")["frame_hashes"]);
}

TEST_F(ProgramGLTest, AViewThatFollowsAToolWhichATakeDoesNotHaveIsRefused) {
  write_bytes(folder_ / "scene.yaml",
              small_scenario() + "comparison: { set: { depth: 1 mm }, captions: [two, one] }\n");
  expect_good({"run", "scene.yaml", "--no-video", "--out", "run"});
  for (const std::string follow : {"cameras: { close: { follow: { tool: rod } } }\n",
                                   "cameras: { close: { follow: { tool: probe } } }\n"
                                   "comparison: { set: { cameras.close.follow.tool: rod } }\n"}) {
    write_bytes(folder_ / "view.yaml",
                "thinwall: 1\ninclude: [scene.yaml]\ntools: { rod: { kind: point } }\n" + follow);
    const ProgramEnd end = run({"render", "run/take.h5", "--no-video", "--view", "view.yaml", "--out", "viewed"});
    EXPECT_EQ(end.exit_code, 2);
    EXPECT_NE(end.messages.find("camera `close` follows tool `rod`, which the take does not have; its tools: probe"),
              std::string::npos)
        << end.messages;
  }
}

TEST_F(ProgramGLTest, ATakeWithCutsGivesTheFramesOfTheRunAgainAndItsSurfacesGrow) {
  write_bytes(folder_ / "cut.yaml", incision_scenario());
  // Frames lie between steps, and some between the steps before and after a cut.
  expect_good({"run", "cut.yaml", "--no-video", "--surfaces", "--out", "run"});
  expect_good({"render", "run/take.h5", "--no-video"});
  EXPECT_EQ(manifest("run/render")["frame_hashes"], manifest("run")["frame_hashes"]);
  ASSERT_GT(manifest("run")["frames"], 10);
  const auto surface_bytes = [&](const std::string& frame) {
    return file_bytes(folder_ / ("run/surfaces/body_0_" + frame + ".vtp")).size();
  };
  EXPECT_GT(surface_bytes("000010"), surface_bytes("000000"));
  expect_good({"still", "cut.yaml", "--at", "0.3 s", "-o", "still.png"});
  EXPECT_EQ(image_hash(read_png(folder_ / "still.png")), manifest("run")["frame_hashes"][9]);
}

TEST_F(ProgramGLTest, GroundTruthOfAFrameIsTheSameInARunFromItsTakeAndAlone) {
  write_bytes(folder_ / "cut.yaml", incision_scenario());
  expect_good({"run", "cut.yaml", "--no-video", "--aov", "--out", "run"});
  expect_good({"render", "run/take.h5", "--no-video", "--aov"});
  const ProgramEnd still = run({"still", "cut.yaml", "--at", "0.3 s", "-o", "still.png", "--aov", "--json"});
  EXPECT_EQ(nlohmann::json::parse(still.output).at("ground_truth"), "still_ground_truth");
  const auto layers = folder_ / "run/ground_truth";
  int folders = 0;
  for (const auto& layer : std::filesystem::directory_iterator(layers)) {
    if (!layer.is_directory()) {
      const auto name = layer.path().filename();
      EXPECT_EQ(file_bytes(layer.path()), file_bytes(folder_ / "run/render/ground_truth" / name)) << name;
      continue;
    }
    ++folders;
    const auto name = layer.path().filename();
    int frames = 0;
    for (const auto& file : std::filesystem::directory_iterator(layer)) {
      const auto again = folder_ / "run/render/ground_truth" / name / file.path().filename();
      EXPECT_EQ(file_bytes(file.path()), file_bytes(again)) << again;
      ++frames;
      if (file.path().stem() != "frame_000009") continue;
      const std::string alone = "frame_000000" + file.path().extension().string();
      EXPECT_EQ(file_bytes(file.path()), file_bytes(folder_ / "still_ground_truth" / name / alone)) << name;
    }
    EXPECT_EQ(frames, manifest("run")["frames"]) << name;
  }
  EXPECT_EQ(folders, 15);
}

TEST_F(ProgramGLTest, GroundTruthOfAStillIsThatOfTheRecordingsFrameInFreezesAndAroundSlowMotion) {
  write_bytes(folder_ / "slow.yaml",
              small_scenario() +
                  "teaching: { title_card: { title: Slowly, for: 40 ms }, freezes: [ { at: 80 "
                  "ms, for: 50 ms } ], slow_motion: [ { from: 0, until: 80 ms, speed: 0.5 } ] }\n");
  expect_good({"run", "slow.yaml", "--no-video", "--aov", "--out", "run"});
  const auto layers = folder_ / "run/ground_truth";
  // The first frame after the card, one in slow motion, the first that stands still.
  for (const auto& [time, frame] : {std::pair{"0 s", 1}, std::pair{"40 ms", 3}, std::pair{"80 ms", 5}}) {
    expect_good({"still", "slow.yaml", "--at", time, "-o", "still.png", "--aov"});
    for (const char* layer : {"depth", "forward_flow", "backward_flow"}) {
      const auto of_run = layers / layer / ("frame_00000" + std::to_string(frame) + ".exr");
      EXPECT_TRUE(file_bytes(of_run) == file_bytes(folder_ / "still_ground_truth" / layer / "frame_000000.exr"))
          << time << ' ' << layer;
    }
  }
}

TEST_F(ProgramGLTest, AStillBeforeAFreezeHasTheTitleOfTheRecording) {
  std::string text = small_scenario() + "teaching: { freezes: [ { at: 80 ms, for: 50 ms } ] }\n";
  const std::string title = "A small hemisphere";
  text.replace(text.find(title), title.size(),
               title + " whose title reaches to the time where no badge comes before it");
  write_bytes(folder_ / "taught.yaml", text);
  expect_good({"run", "taught.yaml", "--no-video", "--out", "run"});
  expect_good({"still", "taught.yaml", "--at", "40 ms", "-o", "still.png"});
  EXPECT_EQ(image_hash(read_png(folder_ / "still.png")), manifest("run")["frame_hashes"][1]);
}

TEST_F(ProgramGLTest, ATakeShowsItsNumbersInColorsWithTheRangeOfTheWhole) {
  write_bytes(folder_ / "cut.yaml", incision_scenario());
  expect_good({"run", "cut.yaml", "--no-render", "--out", "run"});
  const auto pictures_of = [this](std::vector<std::string> options, const std::string& out) {
    options.insert(options.begin(), {"render", "run/take.h5", "--no-video", "--out", out});
    expect_good(options);
    return manifest(out)["frame_hashes"].dump();
  };
  std::map<std::string, std::string> pictures;
  for (const std::string quantity : {"von_mises_stress", "strain", "thickness", "contact_pressure", "displacement"}) {
    pictures.emplace(pictures_of({"--data", quantity}, quantity), quantity);
  }
  EXPECT_EQ(pictures.size(), 5U) << "two quantities look alike";
  for (const std::vector<std::string>& change :
       {std::vector<std::string>{"--mesh"}, {"--data-from", "-5%"}, {"--data-to", "0.3"}, {"--data-scale", "root"}}) {
    std::vector<std::string> options = {"--data", "strain"};
    options.insert(options.end(), change.begin(), change.end());
    EXPECT_TRUE(pictures.emplace(pictures_of(options, change.front()), change.front()).second) << change.front();
  }
  const ProgramEnd without = run({"render", "run/take.h5", "--data-scale", "root"});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_NE(without.messages.find("name one with --data, or with --view"), std::string::npos) << without.messages;
  write_bytes(folder_ / "data.yaml", incision_scenario() + "look: { data: { shows: strain } }\n");
  const ProgramEnd end = run({"run", "data.yaml"});
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_NE(end.messages.find("`from` and `to` are needed here"), std::string::npos) << end.messages;
  expect_good({"render", "run/take.h5", "--no-video", "--view", "data.yaml", "--out", "viewed"});
  write_bytes(folder_ / "fixed.yaml", incision_scenario() + "look: { data: { shows: strain, from: 0, to: 0.5 } }\n");
  expect_good({"still", "fixed.yaml", "--at", "0.2 s", "-o", "still.png"});
}

TEST_F(ProgramGLTest, BothHalvesOfAComparisonShowTheNumbersAndTurn) {
  write_bytes(folder_ / "two.yaml",
              small_scenario() + "comparison: { set: { depth: 1 mm }, captions: [deep, shallow] }\n");
  write_bytes(folder_ / "turned.yaml", small_scenario() + "camera: { position: [60 mm, 0, 60 mm] }\n");
  expect_good({"run", "two.yaml", "--no-render", "--out", "run"});
  // How many pixels of each half differ in the picture of the deepest pressing.
  const auto differences = [this](const std::string& one, const std::string& other) {
    const Image a = read_png(folder_ / one / "frames/frame_000002.png");
    const Image b = read_png(folder_ / other / "frames/frame_000002.png");
    std::array<int, 2> changed{};
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
      const bool is_right =
          i / 3 % static_cast<std::size_t>(a.size.width) >= static_cast<std::size_t>(a.size.width / 2);
      changed[is_right ? 1 : 0] += !std::equal(&a.pixels[i], &a.pixels[i] + 3, &b.pixels[i]);
    }
    return changed;
  };
  const std::vector<std::pair<std::string, std::vector<std::string>>> renderings = {
      {"tissue", {}},
      {"mesh", {"--mesh"}},
      {"strain", {"--data", "strain"}},
      {"from", {"--data", "strain", "--data-from", "-20%"}},
      {"to", {"--data", "strain", "--data-to", "3"}},
      {"root", {"--data", "strain", "--data-scale", "root"}},
      {"view", {"--view", "turned.yaml"}}};
  for (const auto& [out, options] : renderings) {
    std::vector<std::string> arguments = {"render", "run/take.h5", "--no-video", "--frames", "--out", out};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_good(arguments);
    if (out == "tissue") continue;
    const auto [left, right] = differences(out == "root" || out == "from" || out == "to" ? "strain" : "tissue", out);
    EXPECT_GT(left, 400) << out;
    EXPECT_GT(right, 400) << out;
  }
  // The left take alone is the same; the right one bears more, and its range is that of both.
  write_bytes(folder_ / "deeper.yaml",
              small_scenario() + "comparison: { set: { depth: 5 mm }, captions: [deep, shallow] }\n");
  expect_good({"run", "deeper.yaml", "--no-render", "--out", "deeper"});
  expect_good({"render", "deeper/take.h5", "--no-video", "--frames", "--data", "strain", "--out", "range"});
  EXPECT_GT(differences("strain", "range")[0], 400);
}

TEST_F(ProgramGLTest, TheSecondTakeKeepsTheNumbersThatItAloneShows) {
  const std::string compared =
      small_scenario() + "look: { mesh: false }\ncomparison: { captions: [seen, strain], set: ";
  write_bytes(folder_ / "two.yaml", compared + "{ look.data: { shows: strain, from: 0, to: 0.3 } } }\n");
  expect_good({"run", "two.yaml", "--no-video", "--frames", "--out", "run"});
  expect_good({"render", "run/take.h5", "--no-video", "--frames", "--out", "again"});
  EXPECT_EQ(read_png(folder_ / "again/frames/frame_000002.png").pixels,
            read_png(folder_ / "run/frames/frame_000002.png").pixels);
  write_bytes(folder_ / "open.yaml", compared + "{ look.data: { shows: strain } } }\n");
  const ProgramEnd end = run({"run", "open.yaml", "--no-video", "--out", "open"});
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_NE(end.messages.find("`from` and `to` are needed here"), std::string::npos) << end.messages;
  expect_good({"run", "open.yaml", "--no-render", "--out", "open"});
  expect_good({"render", "open/take.h5", "--no-video", "--out", "whole"});
}

TEST_F(ProgramGLTest, StatisticsTellEachPassAndAnEmptyFrameAndChangeNoPicture) {
  expect_good({"run", "scenes/small.yaml", "--no-video", "--out", "plain"});
  const ProgramEnd end = run({"run", "scenes/small.yaml", "--no-video", "--stats", "--json", "--out", "timed"});
  ASSERT_EQ(end.exit_code, 0) << end.messages;
  const nlohmann::json passes = nlohmann::json::parse(end.output)["passes_ms"];
  for (const std::string pass :
       {"meshes", "surface", "tissue", "floor", "tools", "backdrop", "read-back", "an empty frame"}) {
    EXPECT_GT(passes[pass], 0) << pass;
    EXPECT_NE(end.messages.find(" " + pass + " "), std::string::npos) << pass;
  }
  EXPECT_EQ(manifest("timed")["frame_hashes"], manifest("plain")["frame_hashes"]);
  const ProgramEnd still = run({"still", "scenes/small.yaml", "--at", "0", "-o", "still.png", "--stats"});
  EXPECT_NE(still.messages.find("an empty frame"), std::string::npos) << still.messages;
}

TEST_F(ProgramGLTest, GroundTruthReplacesThatOfAnEarlierRunAndNothingElse) {
  expect_good({"run", "scenes/small.yaml", "--no-video", "--aov", "--out", "run"});
  expect_good({"run", "scenes/small.yaml", "--no-video", "--out", "run"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run/ground_truth"));
  std::filesystem::create_directory(folder_ / "run/ground_truth");
  write_bytes(folder_ / "run/ground_truth/notes.txt", "mine");
  const ProgramEnd end = run({"run", "scenes/small.yaml", "--no-video", "--aov", "--out", "run"});
  EXPECT_EQ(end.exit_code, 4);
  EXPECT_NE(end.messages.find("notes.txt"), std::string::npos) << end.messages;
  EXPECT_EQ(file_bytes(folder_ / "run/ground_truth/notes.txt"), "mine");
}

/// Whether scripts/read-ground-truth reads a frame of the folder's run; what it prints is in summary.txt, what it
/// complains of in complaint.txt.
bool reads_ground_truth(const TemporaryFolder& folder, const std::string& frame) {
  const std::string command = std::string(THINWALL_SOURCE_DIR) + "/scripts/read-ground-truth '" +
                              (folder / "run/ground_truth").string() + "' " + frame + " > '" +
                              (folder / "summary.txt").string() + "' 2> '" + (folder / "complaint.txt").string() + "'";
  return std::system(command.c_str()) == 0;
}

/// What it prints; empty where it fails.
std::string ground_truth_summary(const TemporaryFolder& folder, int frame) {
  return reads_ground_truth(folder, std::to_string(frame)) ? file_bytes(folder / "summary.txt") : "";
}

TEST_F(ProgramGLTest, TheScriptForGroundTruthSaysWhichFramesThereAreAndWhichFileHasNoWholeHeader) {
  expect_good({"run", "scenes/small.yaml", "--no-video", "--aov", "--out", "run"});
  for (const char* frame : {"3000", "third", "-1"}) {
    EXPECT_FALSE(reads_ground_truth(folder_, frame));
    const std::string complaint = file_bytes(folder_ / "complaint.txt");
    EXPECT_EQ(complaint.find(std::string(frame) + ": there is no such frame; choose one of 0 to "), 0U) << complaint;
  }
  const std::filesystem::path normals = folder_ / "run/ground_truth/normals/frame_000001.exr";
  write_bytes(normals, file_bytes(normals).substr(0, 100));
  EXPECT_FALSE(reads_ground_truth(folder_, "1"));
  const std::string complaint = file_bytes(folder_ / "complaint.txt");
  EXPECT_NE(complaint.find("normals/frame_000001.exr: cannot be read whole"), std::string::npos) << complaint;
  EXPECT_EQ(complaint.find("Traceback"), std::string::npos) << complaint;
}

TEST_F(ProgramGLTest, TheScriptForGroundTruthReadsEachLayer) {
  expect_good({"run", "scenes/small.yaml", "--no-video", "--aov", "--out", "run"});
  const std::string summary = ground_truth_summary(folder_, 3);
  for (const std::string layer :
       {"depth ", "depth_16", "normals", "instances", "parts", "materials", "forward_flow ", "forward_flow_kitti",
        "forward_state", "backward_flow ", "backward_flow_kitti", "backward_state", "stress", "contact_pressure",
        "wound", "cameras.csv", "intrinsics.yml", "tools.csv"}) {
    EXPECT_NE(summary.find("\n" + layer), std::string::npos) << layer << "\n" << summary;
  }
  EXPECT_NE(summary.find("as instances: True"), std::string::npos) << summary;
  EXPECT_EQ(summary.find("as instances: False"), std::string::npos) << summary;
}

TEST_F(ProgramGLTest, TheScriptForGroundTruthSeesToolsThroughTheLensOfTheFramesOwnCamera) {
  write_bytes(folder_ / "two_lenses.yaml",
              small_scenario() +
                  "camera: { lens: { k1: -0.3 } }\n"
                  "cameras: { side: { position: [90 mm, -20 mm, 10 mm], target: [0, -20 mm, 10 mm],\n"
                  "                   field_of_view: 60 deg, lens: { k1: 0.4 } } }\n"
                  "cuts: [ { at: 0 s, camera: main }, { at: 20 ms, camera: side } ]\n");
  expect_good({"run", "two_lenses.yaml", "--no-video", "--aov", "--out", "run"});
  // After 40 ms the tip is at (0, 0, 20.2 mm): x = 20 / 90 to the right of the line of sight, y = 10.2 / 90 above it,
  // where the lens magnifies by 1 + 0.4 (x^2 + y^2) = 1.0249. A tangent of one is 48 / tan 30 degrees = 83.14 pixels.
  const std::string summary = ground_truth_summary(folder_, 1);
  EXPECT_NE(summary.find("probe (approach), its tip at pixel [98.4 37.8]"), std::string::npos) << summary;
}

TEST_F(ProgramGLTest, ATakeCanBeRenderedInAnotherSizeAndView) {
  expect_good({"run", "scenes/small.yaml", "--no-render", "--out", "run"});
  write_bytes(folder_ / "view.yaml",
              small_scenario() + "camera: { position: [0, -90 mm, 20 mm], target: [0, 0, 10 mm] }\n");
  expect_good({"render", "run/take.h5", "--size", "200x120", "--fps", "50", "--frames", "--out", "as_it_was"});
  expect_good({"render", "run/take.h5", "--size", "200x120", "--fps", "50", "--view", "view.yaml", "--out", "other"});
  EXPECT_EQ(read_png(folder_ / "as_it_was/frames/frame_000000.png").size, (ImageSize{.width = 200, .height = 120}));
  EXPECT_NE(manifest("as_it_was")["frame_hashes"], manifest("other")["frame_hashes"]);
}

TEST_F(ProgramGLTest, AStillIsTheFrameOfThatTime) {
  expect_good({"run", "scenes/small.yaml", "--no-video", "--out", "run"});
  const ProgramEnd still = run({"still", "scenes/small.yaml", "--at", "120 ms", "-o", "still.png", "--json"});
  EXPECT_EQ(image_hash(read_png(folder_ / "still.png")), manifest("run")["frame_hashes"][3]);
  const nlohmann::json told = nlohmann::json::parse(still.output);
  EXPECT_EQ(told.at("hash"), manifest("run")["frame_hashes"][3]);
  EXPECT_EQ(told.at("driver"), manifest("run")["driver"]);
  EXPECT_EQ(told.at("exit_code"), 0);
  EXPECT_FALSE(told.contains("ground_truth"));
  EXPECT_EQ(run({"still", "scenes/small.yaml", "--at", "1000s", "-o", "late.png"}).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "late.png"));
}

TEST_F(ProgramGLTest, ADoctorTellsWhatIsThere) {
  const ProgramEnd end = run({"doctor", "--json"});
  const nlohmann::json findings = nlohmann::json::parse(end.output);
  EXPECT_EQ(end.exit_code, 0) << end.output;
  EXPECT_EQ(findings.value("exit_code", -1), 0);
  EXPECT_FALSE(findings["pictures"]["devices"].empty());
  EXPECT_EQ(findings["pictures"]["problem"], "");
  EXPECT_EQ(findings["video"]["libx264"], true);
  EXPECT_EQ(nlohmann::json::parse(run({"doctor", "--json", "--device", "99"}).output).value("exit_code", -1), 4);
}

}  // namespace
}  // namespace thinwall
