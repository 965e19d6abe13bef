#include <gtest/gtest.h>
#include <sys/file.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "studio/take/TakeReader.hpp"
#include "tests/studio/commands/ProgramFixture.hpp"

namespace thinwall {
namespace {

TEST_F(ProgramTest, SaysItsVersionAndLicence) {
  const ProgramEnd end = run({"--version"});
  EXPECT_EQ(end.exit_code, 0);
  EXPECT_EQ(end.output.find("thinwall "), 0U);
  EXPECT_NE(end.output.find("MIT"), std::string::npos);
}

TEST_F(ProgramTest, HelpIsGoodUsage) {
  EXPECT_EQ(run({"--help"}).exit_code, 0);
  const ProgramEnd of_run = run({"run", "--help"});
  EXPECT_EQ(of_run.exit_code, 0);
  EXPECT_NE(of_run.output.find("--no-render  "), std::string::npos) << of_run.output;
  EXPECT_EQ(run({"golden", "approve", "--help"}).exit_code, 0);
}

TEST_F(ProgramTest, ToCompareIsTheSameForTheProgramThatDoesOnlyThatAndTheOneWithAllCommands) {
  const std::string start = "P5\n2 1\n255\n";
  write_bytes(folder_ / "a.pgm", start + "ab");
  write_bytes(folder_ / "b.pgm", start + "aq");
  const auto expect_same = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> option_first{"--json", "compare"};
    option_first.insert(option_first.end(), arguments.begin(), arguments.end());
    std::vector<std::string> command_first{"compare", "--json"};
    command_first.insert(command_first.end(), arguments.begin(), arguments.end());
    const ProgramEnd of_all = run(option_first);
    const ProgramEnd alone = run(command_first);
    EXPECT_EQ(alone.exit_code, of_all.exit_code);
    EXPECT_EQ(alone.output, of_all.output);
    EXPECT_EQ(alone.messages, of_all.messages);
    EXPECT_FALSE(alone.output.empty() && alone.messages.empty());
  };
  expect_same({"a.pgm", "b.pgm", "--metric", "all"});
  expect_same({"a.pgm", "b.pgm", "--max", "900"});
  expect_same({"--help"});
}

TEST_F(ProgramTest, ToCompareLoadsNoLibraryOfSimulationGraphicsOrTakes) {
  const std::string tell = std::string("ldd ") + THINWALL_PROGRAM + " > " + (folder_ / "libraries").string();
  ASSERT_EQ(std::system(tell.c_str()), 0);
  const std::string libraries = file_bytes(folder_ / "libraries");
  EXPECT_NE(libraries.find("libpng"), std::string::npos) << libraries;
  for (const char* name : {"openblas", "cholmod", "hdf5", "assimp", "epoxy", "pango", "OpenEXR", "opencv", "tbb"}) {
    EXPECT_EQ(libraries.find(name), std::string::npos) << name;
  }
}

TEST_F(ProgramTest, SaysWhenTheProgramWithAllCommandsIsNotBesideIt) {
  std::filesystem::copy(THINWALL_PROGRAM, folder_ / "thinwall");
  const std::string call = (folder_ / "thinwall").string() + " doctor 2> " + (folder_ / "words").string();
  EXPECT_EQ(WEXITSTATUS(std::system(call.c_str())), 4);
  EXPECT_NE(file_bytes(folder_ / "words").find("thinwall-studio: No such file"), std::string::npos);
  const std::string version = (folder_ / "thinwall").string() + " --version > " + (folder_ / "version").string();
  EXPECT_EQ(WEXITSTATUS(std::system(version.c_str())), 0) << "this it says by itself";
  EXPECT_EQ(file_bytes(folder_ / "version"), run({"--json", "--version"}).output) << "as the other does";
}

TEST_F(ProgramTest, AsksForLargePagesUnlessTheUserOrTheHapticLoopWantsOthers) {
  std::filesystem::copy(THINWALL_PROGRAM, folder_ / "thinwall");
  write_bytes(folder_ / "thinwall-studio", "#!/bin/sh\nprintf %s \"$GLIBC_TUNABLES\"\n");
  std::filesystem::permissions(folder_ / "thinwall-studio", std::filesystem::perms::owner_all);
  const auto asked = [&](const std::string& given, const std::string& command) {
    const std::string call = "GLIBC_TUNABLES=" + given + " " + (folder_ / "thinwall").string() + " " + command + " > " +
                             (folder_ / "words").string();
    EXPECT_EQ(std::system(call.c_str()), 0);
    return file_bytes(folder_ / "words");
  };
  EXPECT_EQ(asked("", "render"), "glibc.malloc.hugetlb=1");
  EXPECT_EQ(asked("glibc.malloc.check=0", "render"), "glibc.malloc.check=0:glibc.malloc.hugetlb=1");
  EXPECT_EQ(asked("glibc.malloc.hugetlb=0", "render"), "glibc.malloc.hugetlb=0");
  for (const char* words : {"haptic small.yaml", "--json haptic small.yaml"}) EXPECT_EQ(asked("", words), "") << words;
}

TEST_F(ProgramTest, BadUsageIsToldWithExitCode2) {
  expect_bad_usage({}, "subcommand is required");
  expect_bad_usage({"walk"}, "there is no command `walk`; see thinwall --help");
  expect_bad_usage({"chek", "small.yaml"}, "there is no command `chek`, did you mean `check`?");
  expect_bad_usage({"golden", "tets"}, "there is no command `golden tets`, did you mean `test`?; see thinwall golden");
  expect_bad_usage({"golden"}, "subcommand is required");
  expect_bad_usage({"run", "small.yaml", "--fast"}, "there is no option --fast here");
  expect_bad_usage({"run", "small.yaml", "--sett", "depth=3mm"}, "no option --sett here, did you mean `--set`?");
  expect_bad_usage({"compare", "a.png", "b.png", "--maxx=3"}, "no option --maxx here, did you mean `--max`?");
  expect_bad_usage({"run"}, "SCENARIO is required");
  expect_bad_usage({"run", "small.yaml", "--device", "fridge"}, "--device fridge");
  expect_bad_usage({"render", "take.h5", "--size", "1280*720"}, "write WIDTHxHEIGHT in pixels");
  expect_bad_usage({"still", "small.yaml", "--at", "3 mm", "-o", "x.png"}, "not a time");
  expect_bad_usage({"still", "small.yaml", "--at", "0 s", "-o=x.jpg"}, "-o x.jpg: the picture is a PNG file");
  expect_bad_usage({"render", "take.h5", "--set", "depth=3mm"}, "--set: a take holds what its run has computed");
  expect_bad_usage({"run", "small.yaml", "--no-render", "--stats"}, "--stats: it measures the pictures");
  expect_bad_usage({"render", "take.h5", "--data", "heat"}, "choose one of von_mises_stress");
  expect_bad_usage({"render", "take.h5", "--data", "strain", "--data-scale", "log"}, "choose one of linear, root");
  expect_bad_usage({"render", "take.h5", "--data", "strain", "--data-from", "3 cows"}, "--data-from 3 cows: unknown");
  expect_bad_usage({"run", "small.yaml", "--aov", "--no-render"}, "--no-render makes none");
  expect_bad_usage({"run", "small.yaml", "--frames", "--no-render"},
                   "--frames: it keeps the pictures, and --no-render");
}

TEST_F(ProgramTest, ExpectationsAreCheckedByEveryRunAndAFailedOneIsExitCode1) {
  const auto scenario = [](const std::string& pressure) {
    return small_scenario() + "expect:\n  - { quantity: peak_force, within: [1 mN, 10 mN] }\n" +
           "  - { quantity: pressure, at: 0, value: " + pressure + ", tolerance: 1 Pa }\n";
  };
  write_bytes(folder_ / "met.yaml", scenario("0"));
  write_bytes(folder_ / "missed.yaml", scenario("9 kPa"));
  const ProgramEnd met = run({"run", "met.yaml", "--no-render", "--out", "met"});
  EXPECT_EQ(met.exit_code, 0) << met.messages;
  EXPECT_NE(met.messages.find("met.yaml:18:5: met: pressure of body `organ` is "), std::string::npos) << met.messages;
  const ProgramEnd missed = run({"run", "missed.yaml", "--no-render", "--json", "--out", "missed"});
  EXPECT_EQ(missed.exit_code, 1) << missed.messages;
  EXPECT_NE(missed.messages.find("missed.yaml:18:5: FAILED: pressure"), std::string::npos) << missed.messages;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "missed" / "take.h5")) << "its files are whole nevertheless";
  const nlohmann::json results = manifest("missed").at("expectations");
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].at("passed"), true);
  EXPECT_EQ(results[1].at("passed"), false);
  EXPECT_EQ(results[1].at("within"), nlohmann::json({8999., 9001.}));
  EXPECT_EQ(manifest("missed").at("result"), "an expectation failed");
  const nlohmann::json told = nlohmann::json::parse(missed.output);
  EXPECT_EQ(told.at("expectations"), results);
  EXPECT_EQ(told.at("exit_code"), 1);
}

TEST_F(ProgramTest, TextsWithLettersThatTheFontHasNotAreTold) {
  // A control character is spelled out: a terminal would obey it.
  const std::string clip = "  - palpate: { depth: 1 mm, caption: \"\u16a0 \\x1b pressed\" }\n";
  write_bytes(folder_ / "letters.yaml", small_scenario(clip));
  const ProgramEnd end = run({"run", "letters.yaml", "--no-render", "--out", "letters"});
  EXPECT_EQ(end.exit_code, 0) << end.messages;
  const std::string note =
      "letters.yaml: warning: timeline[2].palpate.caption: the font of pictures has no shape for \u16a0\\x1b,";
  EXPECT_NE(end.messages.find(note), std::string::npos) << end.messages;
  const std::string as_json = nlohmann::json(note).dump();
  EXPECT_NE(manifest("letters").at("warnings").dump().find(as_json.substr(0, as_json.size() - 1)), std::string::npos);
  EXPECT_NE(run({"check", "letters.yaml"}).messages.find(note), std::string::npos);
}

TEST_F(ProgramTest, NotesThatAreKnownBeforeTheFirstStepAreToldBeforeIt) {
  const ProgramEnd end = run({"run", "small.yaml", "--no-render", "--out", "out"});
  const std::size_t note = end.messages.find("thinwall: note: ");
  EXPECT_LT(note, end.messages.find("recording 0 %")) << end.messages;
  const std::string size = "64 triangles (64 wanted)";
  EXPECT_EQ(end.messages.find(size), end.messages.rfind(size)) << "told twice";
}

TEST_F(ProgramTest, IncisionsThatCannotBeAreBadInputWithThePlaceAndTheCure) {
  const auto expect_refused = [&](const std::string& incise, const std::string& words) {
    write_bytes(folder_ / "cut.yaml", incision_scenario(incise));
    expect_bad_usage({"run", "cut.yaml", "--no-render"}, words);
  };
  const std::string off_the_wall = "path: [[0, 0, 20 mm], [0, 35 mm, 5 mm]], depth: 3 mm";
  expect_refused(off_the_wall, "cut.yaml:11:95: error: timeline[1].incise: path[2] = [0, 35, 5] mm lies 14.");
  expect_refused(off_the_wall,
                 "mm then, farther than `reach` = 10 mm; move the point to the wall or give a larger "
                 "`reach`");
  expect_refused("path: [[0, 0, 20 mm], [5 mm, 0, 20 mm]], depth: 13 mm", "`blade` is only 12 mm long");
  expect_refused("path: [[0, 0, 20 mm], [5 mm, 0, 20 mm]], depth: 3 mm, direction: [1, 0, 0], reach: 60 mm",
                 "all points of `path` come to lie in one place of body `organ`; a cut needs a length");
  expect_refused("path: [[0, 0, 20 mm], [35 mm, 0, 20 mm]], depth: 3 mm, direction: [0, 0, -1]",
                 "does not meet body `organ` along `direction`; move the point or leave `direction` out");
  write_bytes(folder_ / "needle.yaml", small_scenario("  - pierce: { tool: probe, body: organ, depth: 3 mm }\n"));
  expect_bad_usage({"run", "needle.yaml", "--no-render"}, "only a `needle` can pierce");
}

TEST_F(ProgramTest, RecordedPointsAreFollowedInAFileOfTheirOwn) {
  std::string scenario = small_scenario();
  scenario.replace(scenario.find("tier: draft"), 11, "tier: draft, points: { crown: { at: [0, 0, 21 mm] } }");
  write_bytes(folder_ / "points.yaml", scenario);
  ASSERT_EQ(run({"run", "points.yaml", "--no-render", "--out", "points"}).exit_code, 0);
  const std::string rows = file_bytes(folder_ / "points" / "points.csv");
  EXPECT_TRUE(rows.starts_with("time_s,body,point,x_m,y_m,z_m,ux_m,uy_m,uz_m\n0,organ,crown,0,0,0.02,0,0,0\n")) << rows;
  const auto steps = manifest("points").at("steps").get<long>();
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), steps + 1);
  run({"run", "small.yaml", "--no-render", "--out", "points"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "points" / "points.csv")) << "it would be of another run";
}

TEST_F(ProgramTest, AMissingScenarioIsBadInput) {
  expect_bad_usage({"run", "none.yaml"}, "none.yaml:1:1: error: no such file");
  expect_bad_usage({"check", "small.yaml", "none.yaml"}, "none.yaml:1:1: error: no such file");
  expect_bad_usage({"render", "none.h5"}, "none.h5: there is no such file");
}

TEST_F(ProgramTest, AnOverrideThatCannotBeUsedIsBadInput) {
  expect_bad_usage({"run", "small.yaml", "--set", "depth"}, "--set depth: write the parameter as name=value");
  expect_bad_usage({"run", "small.yaml", "--set", "dephth=3mm"}, "dephth");
  expect_bad_usage({"check", "--set", "depth=3kg", "small.yaml"}, "small.yaml:");
}

TEST_F(ProgramTest, CheckRefusesTheClipsThatARunWouldRefuseAllOfThem) {
  write_bytes(folder_ / "misses.yaml",
              "thinwall: 1\n"
              "bodies:\n"
              "  ball:\n"
              "    surface: { shape: sphere, radius: 20 mm, triangles: 20 }\n"
              "    wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 20 kPa } }\n"
              "tools: { finger: { kind: sphere } }\n"
              "timeline:\n"
              "  - palpate: { at: [50 mm, 0, 0], depth: 2 mm }\n"
              "  - palpate: { depth: 2 mm }\n"
              "  - palpate: { at: [0, 70 mm, 0], depth: 2 mm }\n");
  for (const std::string command : {"check", "run"}) {
    const ProgramEnd end = run({command, "misses.yaml"});
    EXPECT_EQ(end.exit_code, 2) << end.messages;
    EXPECT_NE(end.messages.find("misses.yaml:8:5: error: timeline[1].palpate: the line of approach"), std::string::npos)
        << end.messages;
    EXPECT_NE(end.messages.find("misses.yaml:10:5: error: timeline[3].palpate: the line of approach"),
              std::string::npos)
        << end.messages;
  }
}

TEST_F(ProgramTest, RunsWithoutGraphics) {
  const ProgramEnd end = run({"run", "small.yaml", "--no-render", "--json", "--set", "depth=1mm"});
  ASSERT_EQ(end.exit_code, 0) << end.messages;
  EXPECT_EQ(nlohmann::json::parse(end.output)["folder"], "out/small");
  EXPECT_EQ(nlohmann::json::parse(end.output)["exit_code"], 0);
  const nlohmann::json manifest = this->manifest("out/small");
  EXPECT_EQ(manifest["result"], "ok");
  EXPECT_EQ(manifest["complete"], true);
  EXPECT_EQ(manifest["options"]["set"]["depth"], "1mm");
  EXPECT_EQ(manifest["frames"], 0);
  EXPECT_TRUE(manifest["driver"].is_null());
  EXPECT_EQ(manifest["scenario"]["hash"].get<std::string>().size(), 32U);
  EXPECT_NE(manifest["licence"].get<std::string>().find("Apache-2.0"), std::string::npos);
  EXPECT_EQ(manifest["files"],
            nlohmann::json({"forces.csv", "body.csv", "take.h5", "captions.vtt", "forces.png", "energies.png"}));
  const TakeReader take(folder_ / "out/small/take.h5");
  EXPECT_TRUE(take.ending().complete);
  EXPECT_EQ(manifest["steps"], take.times().size());
  EXPECT_EQ(manifest["state_digest"], take.ending().state_digest);
}

TEST_F(ProgramTest, TheSameScenarioTwiceLeavesTheSameBytes) {
  for (const char* out : {"one", "two"}) {
    ASSERT_EQ(run({"run", "small.yaml", "--no-render", "--out", out}).exit_code, 0);
  }
  for (const char* file : {"take.h5", "forces.csv", "body.csv", "captions.vtt", "forces.png", "energies.png"}) {
    EXPECT_TRUE(file_bytes(folder_ / "one" / file) == file_bytes(folder_ / "two" / file)) << file;
  }
  EXPECT_EQ(manifest("one")["state_digest"], manifest("two")["state_digest"]);
}

TEST_F(ProgramTest, AnyNumberOfThreadsLeavesTheSameBytes) {
  std::string fine = small_scenario();
  fine.replace(fine.find("triangles: 64"), 13, "triangles: 1500");
  write_bytes(folder_ / "fine.yaml", fine);
  for (const char* threads : {"1", "2", "5"}) {
    const ProgramEnd end = run({"run", "fine.yaml", "--no-render", "--threads", threads, "--out", threads});
    ASSERT_EQ(end.exit_code, 0) << end.messages;
  }
  for (const char* threads : {"2", "5"}) {
    EXPECT_TRUE(file_bytes(folder_ / threads / "take.h5") == file_bytes(folder_ / "1" / "take.h5")) << threads;
    EXPECT_EQ(manifest(threads)["state_digest"], manifest("1")["state_digest"]);
  }
  expect_bad_usage({"run", "fine.yaml", "--threads", "0"}, "--threads");
}

TEST_F(ProgramTest, TheOrderOfOptionsDoesNotMatter) {
  ASSERT_EQ(run({"run", "small.yaml", "--out", "one", "--set", "depth=1mm", "--no-render"}).exit_code, 0);
  ASSERT_EQ(run({"--no-render", "--set", "depth=1mm", "run", "--out", "two", "small.yaml"}).exit_code, 0);
  EXPECT_EQ(file_bytes(folder_ / "one/forces.csv"), file_bytes(folder_ / "two/forces.csv"));
  // A value that is spelled as a command is a value.
  ASSERT_EQ(run({"--out", "check", "--no-render", "run", "small.yaml"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "check/forces.csv"));
}

TEST_F(ProgramTest, ProgressIsALinePerTenPerCentWhereThereIsNoTerminal) {
  const ProgramEnd end = run({"run", "small.yaml", "--no-render"});
  EXPECT_NE(end.messages.find("recording 50 %"), std::string::npos) << end.messages;
  EXPECT_NE(end.messages.find("recording 100 %"), std::string::npos) << end.messages;
  EXPECT_EQ(end.messages.find('\r'), std::string::npos);
  EXPECT_EQ(end.output, "");
}

TEST_F(ProgramTest, GoldensAreApprovedInAnotherFolderThanOneInUse) {
  std::filesystem::create_directory(folder_ / "out");
  const int other = open((folder_ / "out" / ".in_use").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  write_bytes(folder_ / "golden.yaml", small_scenario() + "golden: [ { at: 0.1 s, max: 8, mean: 0.2, why: first } ]\n");
  const std::vector<std::string> approve = {"golden", "approve", "golden.yaml", "--device", "99", "--why", "new"};
  const auto approve_in = [&](const std::string& out) {
    std::vector<std::string> arguments = approve;
    arguments.insert(arguments.end(), {"--out", out});
    return run(arguments);
  };
  EXPECT_EQ(approve_in("out").exit_code, 2);
  const ProgramEnd elsewhere = approve_in("elsewhere");
  EXPECT_EQ(elsewhere.messages.find("wait until it has ended"), std::string::npos) << elsewhere.messages;
  EXPECT_EQ(elsewhere.exit_code, 4) << "there is no device 99";
  close(other);
}

TEST_F(ProgramTest, GoldensAreApprovedOnlyByNameWithAReasonAndByAPerson) {
  expect_bad_usage({"golden", "approve", "small.yaml"}, "say with --why");
  expect_bad_usage({"golden", "approve", "--why", " ", "small.yaml"}, "say with --why");
  expect_bad_usage({"golden", "approve", "--why", "new"}, "name the scenarios");
  const ProgramEnd end =
      run({"golden", "approve", "--why", "new", "small.yaml"}, {.folder = {}, .environment = {{"CI", "true"}}});
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_NE(end.messages.find("not in CI"), std::string::npos) << end.messages;
}

TEST_F(ProgramTest, AStillIsAPngFileByItsName) {
  expect_bad_usage({"still", "small.yaml", "--at", "0.1s", "-o", "still.xyz"}, "let its name end with .png");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "still.xyz"));
}

TEST_F(ProgramTest, GoldensOfAllScenariosLeaveOutFragmentsAndStopAtNoBrokenOne) {
  const std::filesystem::path scenes = folder_ / "scenes";
  std::filesystem::create_directory(scenes);
  const std::string golden = "golden: [ { at: 0.1 s, max: 8, mean: 0.2, why: first } ]\n";
  write_bytes(scenes / "good.yaml", small_scenario() + golden);
  write_bytes(scenes / "fragment.yaml", "camera: { kind: endoscope }\n");
  write_bytes(scenes / "base.yaml", "parameters: { speed: 20 mm/s }\n" + golden);
  const ProgramSetting home{.folder = {}, .environment = {{"THINWALL_HOME", folder_.path()}}};
  write_bytes(scenes / "user.yaml", "include: [fragment.yaml, base.yaml]\n" +
                                        small_scenario("  - palpate: { depth: 1 mm, speed: \"${speed}\" }\n"));
  ProgramEnd end = run({"golden", "list"}, home);
  EXPECT_EQ(end.exit_code, 0) << end.messages;
  for (const char* name : {"good", "user"}) EXPECT_NE(end.output.find(name), std::string::npos) << end.output;
  EXPECT_EQ(end.messages, "") << "a fragment and a base that others include are no scenarios";
  write_bytes(scenes / "bad.yaml", "bodies: 3\n" + golden);
  for (const char* verb : {"list", "test", "report"}) {
    end = run({"golden", verb}, home);
    EXPECT_EQ(end.exit_code, 2) << verb;
    EXPECT_NE(end.messages.find("bad.yaml:1:"), std::string::npos) << end.messages;
    for (const char* name : {"fragment.yaml:", "base.yaml:"}) {
      EXPECT_EQ(end.messages.find(name), std::string::npos) << end.messages;
    }
    EXPECT_NE((end.output + end.messages).find("good"), std::string::npos) << verb;
  }
}

TEST_F(ProgramTest, ToCompareNothingIsAnError) {
  const ProgramSetting empty_home{.folder = {}, .environment = {{"THINWALL_HOME", folder_.path()}}};
  EXPECT_EQ(run({"golden", "test"}, empty_home).exit_code, 2);
  expect_bad_usage({"golden", "test", "small.yaml"}, "has no `golden:` list");
}

}  // namespace
}  // namespace thinwall
