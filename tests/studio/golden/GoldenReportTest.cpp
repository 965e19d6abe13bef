#include "studio/golden/GoldenReport.hpp"

#include <gtest/gtest.h>

#include "renderer/video/Program.hpp"
#include "studio/golden/GoldenVideoApproval.hpp"
#include "studio/golden/JUnitReport.hpp"
#include "tests/studio/golden/GoldenScene.hpp"

namespace thinwall {
namespace {

class GoldenReportTest : public ::testing::Test {
 protected:
  void SetUp() override { scene_.approve(); }
  JudgedScenario failed() const { return scene_.judge(golden_scene(), synthetic_source({.depth = 0.005})); }
  std::string page() const {
    return golden_report({failed(), scene_.judge(golden_scene())}, scene_.temporary() / "goldens");
  }

  GoldenScene scene_;
};

TEST_F(GoldenReportTest, ThePageStandsByItself) {
  const std::string text = page();
  EXPECT_NE(text.find("data:image/png;base64,iVBOR"), std::string::npos);
  EXPECT_NE(text.find("physics changed from step 1 on"), std::string::npos);
  for (const char* word : {"src=\"http", "href=\"http", "@import", "fetch(", "XMLHttpRequest"}) {
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  }
}

TEST_F(GoldenReportTest, EqualRunsGiveEqualPages) {
  EXPECT_EQ(page(), page());
}

TEST_F(GoldenReportTest, TextsCannotEndTheScript) {
  Scenario scenario = golden_scene();
  scenario.title = "</script><b>";
  const std::string text = golden_report({scene_.judge(scenario)}, scene_.temporary() / "goldens");
  EXPECT_EQ(text.find("</script><b>"), std::string::npos);
}

TEST_F(GoldenReportTest, JUnitKeepsTheOutcomesApart) {
  Scenario early = golden_scene();
  early.goldens[0].at = 99;
  const std::string text = junit_report({failed(), scene_.judge(golden_scene()), scene_.judge(early)});
  EXPECT_NE(text.find("<failure type=\"failed\" message=\"physics changed"), std::string::npos) << text;
  EXPECT_NE(text.find("<testcase classname=\"golden.sheet\" name=\"0.1 s\"/>"), std::string::npos) << text;
  EXPECT_NE(text.find("<error type=\"result missing\""), std::string::npos) << text;
  EXPECT_EQ(text.find("&#"), std::string::npos);
}

TEST_F(GoldenReportTest, NotesForGitHubNameTheLineOfTheScenario) {
  JudgedScenario judged = failed();
  judged.scenario.file = "./scenes/sheet.yaml";
  judged.scenario.goldens[0].location.line = 12;
  EXPECT_EQ(
      github_annotations({judged}).rfind("::error file=scenes/sheet.yaml,line=12,title=sheet at 0.1 s: failed::", 0),
      0U)
      << github_annotations({judged});
}

/// Presses keys as a person does and writes what has come of it into the page.
constexpr const char* kUse = R"(<script>
setTimeout(() => {
  const press = key => document.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
  const facts = [];
  const note = (name, value) => facts.push(name + "=" + value);
  note("chosen", document.querySelector("#view h2").textContent);
  note("panes", document.querySelectorAll("#stage canvas").length);
  const names = [...document.querySelectorAll("#view .bar button")].map(button => button.textContent);
  note("threshold", names.includes("Threshold"));
  press(String(names.indexOf("Threshold") + 1));
  note("amount", document.querySelector("#amount").textContent.includes("above 8 levels"));
  press("2");
  note("swipe", state.mode);
  press("+");
  note("zoom", state.zoom);
  press("a");
  note("command", document.querySelector("#command").textContent);
  press("j");
  setTimeout(() => {
    note("next", document.querySelector("#view .ok") !== null);
    press("d"); press("d");
    document.querySelector("#search").value = "nothing like it";
    document.querySelector("#search").oninput({ target: document.querySelector("#search") });
    note("found", document.querySelectorAll("#list li").length);
    document.body.dataset.result = facts.join(";");
  }, 300);
}, 500);
</script>)";

/// What the page says of itself after a script in it has run; empty without a browser.
std::string facts_of(const std::filesystem::path& folder, const std::string& page) {
  const std::string program = "chromium";
  try {
    run_program({program, "--version"});
  } catch (const std::exception&) {
    return "";
  }
  const std::filesystem::path file = folder / "page.html";
  write_bytes(file, page);
  const ProgramResult result = run_program({"timeout", "-s", "KILL", "120", program, "--headless=new", "--no-sandbox",
                                            "--disable-gpu", "--user-data-dir=" + (folder / "profile").string(),
                                            "--virtual-time-budget=5000", "--dump-dom", "file://" + file.string()});
  const std::size_t at = result.output.find("data-result=\"");
  if (at == std::string::npos) return "no result: " + result.errors;
  return result.output.substr(at + 13, result.output.find('"', at + 13) - at - 13);
}

TEST_F(GoldenReportTest, ABrowserShowsItAndKeysWork) {
  const std::string facts = facts_of(scene_.temporary().path(), page() + kUse);
  if (facts.empty()) GTEST_SKIP() << "there is no chromium here";
  EXPECT_EQ(facts,
            "chosen=sheet at 0.1 s;panes=2;threshold=true;amount=true;swipe=swipe;zoom=1.5;"
            "command=thinwall golden approve sheet@0.1s --why &quot;...&quot;;next=true;found=0");
}

/// Moves the slider of a video's frames.
constexpr const char* kScrub = R"(<script>
setTimeout(() => {
  const facts = [];
  const note = (name, value) => facts.push(name + "=" + value);
  note("chosen", document.querySelector("#view h2").textContent);
  note("panes", document.querySelectorAll("#stage canvas").length);
  note("frames", document.querySelector("#frames").getAttribute("aria-label"));
  note("file", document.querySelector("video").src.startsWith("data:video/mp4"));
  const slider = document.querySelector("#scrub");
  slider.value = 9;
  slider.dispatchEvent(new Event("input"));
  setTimeout(() => {
    note("words", document.querySelector("#frame").textContent);
    note("slider", document.querySelector("#scrub").value);
    document.dispatchEvent(new KeyboardEvent("keydown", { key: "a", bubbles: true }));
    note("command", document.querySelector("#command").textContent);
    document.body.dataset.result = facts.join(";");
  }, 500);
}, 800);
</script>)";

TEST_F(GoldenReportTest, AVideoIsScrubbedInABrowser) {
  Scenario scenario = golden_scene();
  scenario.record.frames_per_second = 50;
  scenario.goldens = {{.video = 3, .max = 8, .mean = 0.2, .why = "rounding"}};
  GoldenRunOptions options = scene_.options(synthetic_source(), view_painters());
  options.videos = scene_.temporary() / "videos";
  const auto judge = [&] {
    return std::move(judge_scenarios({scenario}, options, [](const JudgedScenario&) {}).front());
  };
  renew_golden_video(*judge().video, scene_.folder(), "someone", "it is right");
  options.painters = view_painters(1.2);
  const JudgedScenario judged = judge();
  ASSERT_EQ(judged.results[0].outcome, GoldenOutcome::kFailed);
  const std::string text = golden_report({judged}, scene_.temporary() / "goldens");
  const std::string facts = facts_of(scene_.temporary().path(), text + kScrub);
  if (facts.empty()) GTEST_SKIP() << "there is no chromium here";
  EXPECT_EQ(facts,
            "chosen=sheet the video;panes=2;frames=11 of 11 frames differ;file=true;words=frame 9 at 0.180 s: differs; "
            "compared above: "
            "frame 10;slider=9;command=thinwall golden approve sheet@video --why &quot;...&quot;");
}

}  // namespace
}  // namespace thinwall
