#include "studio/golden/GoldenReport.hpp"

#include <gtest/gtest.h>

#include "renderer/video/Program.hpp"
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
  judged.scenario.file = "scenes/sheet.yaml";
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

TEST_F(GoldenReportTest, ABrowserShowsItAndKeysWork) {
  const std::string program = "chromium";
  try {
    run_program({program, "--version"});
  } catch (const std::exception&) {
    GTEST_SKIP() << "there is no chromium here";
  }
  const std::filesystem::path file = scene_.temporary() / "page.html";
  write_bytes(file, page() + kUse);
  const ProgramResult result =
      run_program({"timeout", "-s", "KILL", "60", program, "--headless=new", "--no-sandbox", "--disable-gpu",
                   "--user-data-dir=" + (scene_.temporary() / "profile").string(), "--virtual-time-budget=5000",
                   "--dump-dom", "file://" + file.string()});
  const std::size_t at = result.output.find("data-result=\"");
  ASSERT_NE(at, std::string::npos) << result.errors;
  const std::string facts = result.output.substr(at, result.output.find('"', at + 13) - at);
  EXPECT_EQ(facts,
            "data-result=\"chosen=sheet at 0.1 s;panes=2;threshold=true;amount=true;swipe=swipe;zoom=1.5;"
            "command=thinwall golden approve sheet@0.1s --why &quot;...&quot;;next=true;found=0");
}

}  // namespace
}  // namespace thinwall
