#include "studio/recorder/VideoScript.hpp"

#include <gtest/gtest.h>

#include "studio/recorder/ShownTexts.hpp"

namespace thinwall {
namespace {

Teaching scripted_lesson() {
  return {.freezes = {{.at = 1, .duration = 2}},
          .slow_motions = {{.begin = 1.5, .end = 2, .speed = 0.5}},
          .title_card = CardScenario{.title = "Begin", .duration = 3},
          .end_card = CardScenario{.title = "End", .duration = 1}};
}

TEST(VideoScript, BeginsWithTheTitleCardOverTheFirstPicture) {
  const VideoScript script(scripted_lesson());
  EXPECT_EQ(script.at(0)->simulation, 0);
  EXPECT_EQ(script.at(0)->card->title, "Begin");
  EXPECT_EQ(script.at(2.5)->card->opacity, 1);
  EXPECT_NEAR(script.at(2.9)->card->opacity, 0.25, 1e-12) << "it goes within 0.4 s";
  EXPECT_FALSE(script.at(3)->card);
  EXPECT_EQ(script.at(3.5)->simulation, 0.5);
}

TEST(VideoScript, SaysThatTheTimeDoesNotRunAsItDoes) {
  const VideoScript script(scripted_lesson());
  EXPECT_EQ(script.at(3.5)->badge, "");
  EXPECT_EQ(script.at(5)->badge, "Paused");
  EXPECT_EQ(script.at(7)->badge, "Slow motion \u00d70.5");
  EXPECT_EQ(script.at(8)->badge, "");
}

TEST(VideoScript, TellsTheBadgesOfAllFramesEachOnce) {
  Teaching lesson = scripted_lesson();
  lesson.freezes.push_back({.at = 3, .duration = 1});
  EXPECT_EQ(VideoScript(lesson).badges(), (std::vector<std::string>{"Paused", "Slow motion \u00d70.5"}));
  lesson.freezes.clear();
  lesson.slow_motions = {{.begin = 1, .end = 2, .speed = 1}};
  EXPECT_TRUE(VideoScript(lesson).badges().empty()) << "a title card covers it, and a speed of 1 has none";
}

TEST(VideoScript, AllFramesOfAFreezeAreTheSame) {
  const VideoScript script(scripted_lesson());
  EXPECT_EQ(*script.at(4.1), *script.at(5.9));
}

TEST(VideoScript, EndsWithTheEndCardOverTheLastPicture) {
  const VideoScript script(scripted_lesson());
  const double end = 2.5;  // shown at 3 + 2 + 2 + 1 = 8 s
  EXPECT_NEAR(script.clock().last_shown(end), 8, 1e-12);
  EXPECT_FALSE(script.at(7.9, end)->card);
  EXPECT_EQ(script.at(8.2, end)->simulation, end);
  EXPECT_EQ(script.at(8.2, end)->card->title, "End");
  EXPECT_NEAR(script.at(8.2, end)->card->opacity, 0.5, 1e-12);
  EXPECT_FALSE(script.at(9.001, end));
  EXPECT_FALSE(script.at(8.2)->card) << "before the end is known";
}

TEST(VideoScript, WithoutTeachingShowsTheSimulationAsItIs) {
  const VideoScript script({});
  EXPECT_EQ(*script.at(1.7), VideoCue{.simulation = 1.7});
  EXPECT_FALSE(script.at(1.8, 1.7));
}

TEST(ShownTexts, CaptionsAndChaptersFollowTheVideosTime) {
  const VideoClock clock({{.at = 0, .duration = 3}, {.at = 1, .duration = 2}}, {});
  const auto captions = shown_captions({{0, 1, "one"}, {1, 2, "two"}}, clock, 3);
  EXPECT_EQ(captions[0], (TimedText{3, 6, "one"})) << "after the title card, with the freeze at its end";
  EXPECT_EQ(captions[1], (TimedText{6, 7, "two"}));
  const auto chapters = shown_chapters({{0, 1, "one"}, {1, 2, "two"}}, clock, 7);
  EXPECT_EQ(chapters[0], (TimedText{0, 4, "one"}));
  EXPECT_EQ(chapters[1], (TimedText{4, 7, "two"}));
}

TEST(ShownTexts, AChapterLastsOverClipsWithoutOneUntilTheNextOrTheEndOfTheVideo) {
  const auto chapters = shown_chapters({{0, 1, "one"}, {2, 3, "two"}}, VideoClock({}, {}), 5);
  EXPECT_EQ(chapters[0], (TimedText{0, 2, "one"}));
  EXPECT_EQ(chapters[1], (TimedText{2, 5, "two"}));
}

TEST(ShownTexts, TheFirstCaptionHoldsInAFreezeAtTheBeginningAsTheFramesShowIt) {
  const VideoClock clock({{.at = 0, .duration = 2}, {.at = 0, .duration = 3}}, {});
  EXPECT_EQ(shown_captions({{0, 1, "one"}}, clock, 2)[0], (TimedText{2, 6, "one"})) << "a card of 2 s, a freeze of 3 s";
  EXPECT_EQ(shown_captions({{0, 1, "one"}}, clock)[0], (TimedText{0, 6, "one"})) << "two freezes";
}

}  // namespace
}  // namespace thinwall
