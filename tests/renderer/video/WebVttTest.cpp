#include "renderer/video/WebVtt.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "renderer/image/WholeFile.hpp"

namespace thinwall {
namespace {

TEST(WebVtt, HasHeaderTimesAndText) {
  EXPECT_EQ(web_vtt({{0.5, 1.25, "Press"}, {3599.9996, 3661, "Hold"}}),
            "WEBVTT\n"
            "\n00:00:00.500 --> 00:00:01.250\nPress\n"
            "\n01:00:00.000 --> 01:01:01.000\nHold\n");
}

TEST(WebVtt, EscapesMarkup) {
  EXPECT_EQ(web_vtt({{0, 1, "p < 5 kPa & F --> <b>"}}),
            "WEBVTT\n\n00:00:00.000 --> 00:00:01.000\np &lt; 5 kPa &amp; F --&gt; &lt;b&gt;\n");
}

TEST(WebVtt, EmptyLinesCannotEndACaption) {
  EXPECT_EQ(web_vtt({{0, 1, "\none\r\n\n\ntwo\n\n"}}), "WEBVTT\n\n00:00:00.000 --> 00:00:01.000\none\ntwo\n");
}

TEST(WebVtt, OfCaptionsThatOverlapTheLastHoldsAndThenTheOneBeforeAgain) {
  EXPECT_EQ(web_vtt(one_at_a_time({{0, 1, "first"}, {1, 5, "long"}, {2, 3, "short"}, {2.5, 3, "shorter"}})),
            "WEBVTT\n\n00:00:00.000 --> 00:00:01.000\nfirst\n\n00:00:01.000 --> 00:00:02.000\nlong\n\n"
            "00:00:02.000 --> 00:00:02.500\nshort\n\n00:00:02.500 --> 00:00:03.000\nshorter\n\n"
            "00:00:03.000 --> 00:00:05.000\nlong\n");
  EXPECT_EQ(web_vtt(one_at_a_time({{0, 2, "one"}, {2, 3, "one"}, {4, 5, ""}, {6, 6, "none"}})),
            web_vtt({{0, 2, "one"}, {2, 3, "one"}}));
}

TEST(WebVtt, AFileHoldsOneCaptionAtATimeAsPicturesDo) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "one_at_a_time.vtt";
  write_web_vtt(file, {{0, 3, "long"}, {1, 2, "short"}});
  EXPECT_EQ(bytes_of_file(file), web_vtt({{0, 1, "long"}, {1, 2, "short"}, {2, 3, "long"}}));
  std::filesystem::remove(file);
}

TEST(WebVtt, LeavesOutWhatTheFormatHasNoPlaceFor) {
  EXPECT_EQ(web_vtt({{0, 1, ""}, {2, 2, "no length"}, {0, 1, "\n"}}), "WEBVTT\n");
}

}  // namespace
}  // namespace thinwall
