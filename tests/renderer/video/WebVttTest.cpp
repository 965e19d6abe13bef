#include "renderer/video/WebVtt.hpp"

#include <gtest/gtest.h>

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

TEST(WebVtt, LeavesOutWhatTheFormatHasNoPlaceFor) {
  EXPECT_EQ(web_vtt({{0, 1, ""}, {2, 2, "no length"}, {0, 1, "\n"}}), "WEBVTT\n");
}

}  // namespace
}  // namespace thinwall
