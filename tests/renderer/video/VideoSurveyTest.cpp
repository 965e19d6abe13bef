#include "renderer/video/VideoSurvey.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/video/FakeProgram.hpp"

namespace thinwall {
namespace {

TEST(VideoSurvey, FindsWhatSetupInstalls) {
  const VideoSurvey survey = survey_video();
  EXPECT_TRUE(survey.ffmpeg);
  EXPECT_TRUE(survey.ffprobe);
  EXPECT_TRUE(survey.libx264);
  EXPECT_TRUE(survey.ffmpeg_version.starts_with("ffmpeg version ")) << survey.ffmpeg_version;
  EXPECT_TRUE(survey.ffprobe_version.starts_with("ffprobe version ")) << survey.ffprobe_version;
  EXPECT_EQ(survey.problem, "");
}

TEST(VideoSurvey, MissingProgramsAreAProblemWithACure) {
  const TestFolder folder;
  const SearchPath path(folder.path().string());
  const VideoSurvey survey = survey_video();
  EXPECT_FALSE(survey.ffmpeg || survey.ffprobe || survey.libx264);
  EXPECT_EQ(survey.problem, "the program ffmpeg cannot be run; install it (on Debian: apt-get install ffmpeg)");
}

TEST(VideoSurvey, OneProgramIsAskedForItsVersionAlone) {
  const TestFolder folder;
  const FakeProgram ffmpeg(folder, "ffmpeg", "echo ffmpeg version 0; echo built with nothing");
  EXPECT_EQ(program_version("ffmpeg"), "ffmpeg version 0");
  EXPECT_EQ(program_version("ffmpreg"), "");
}

TEST(VideoSurvey, MissingEncoderIsAProblemWithACure) {
  const TestFolder folder;
  const FakeProgram ffmpeg(folder, "ffmpeg", "echo ffmpeg version 0");
  const VideoSurvey survey = survey_video();
  EXPECT_EQ(survey.ffmpeg_version, "ffmpeg version 0");
  EXPECT_FALSE(survey.libx264);
  EXPECT_EQ(survey.problem,
            "this ffmpeg has no encoder libx264; install one that has it (on Debian: apt-get install ffmpeg)");
}

}  // namespace
}  // namespace thinwall
