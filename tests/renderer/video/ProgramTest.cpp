#include "renderer/video/Program.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <vector>

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(Program, GivesItsOutputItsErrorsAndItsExitCode) {
  const ProgramResult result = run_program({"sh", "-c", "echo out; echo words >&2; exit 7"});
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_EQ(result.output, "out\n");
  EXPECT_EQ(result.errors, "words\n");
}

TEST(Program, TakesMoreInputThanAnyBufferHolds) {
  Program program({"wc", "-c"});
  const std::string text(3'000'000, 'x');
  EXPECT_TRUE(program.send(bytes_of(text)));
  EXPECT_TRUE(program.send(bytes_of(text)));
  EXPECT_EQ(program.finish().output, "6000000\n");
}

TEST(Program, SaysManyWordsWithoutStopping) {
  const ProgramResult result = run_program({"sh", "-c", "head -c 300000 /dev/zero | tr '\\0' e >&2"});
  EXPECT_EQ(result.errors.size(), 300000u);
}

TEST(Program, EndOfTheProgramIsNoSignalForUs) {
  Program program({"true"});
  const std::string text(1'000'000, 'x');
  EXPECT_FALSE(program.send(bytes_of(text)));
  EXPECT_EQ(program.finish().exit_code, 0);
}

TEST(Program, SignalIsReportedAsTheShellDoes) {
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}).exit_code, 128 + SIGKILL);
}

TEST(Program, ArgumentsGoThroughNoShell) {
  EXPECT_EQ(run_program({"printf", "%s", "$HOME; `ls` \"'"}).output, "$HOME; `ls` \"'");
}

TEST(Program, AnInterruptOfOurGroupDoesNotReachIt) {
  const ProgramResult result = run_program({"sh", "-c", "ps -o pgid= -p $$; echo $$"});
  const std::size_t line_end = result.output.find('\n');
  EXPECT_EQ(std::stoi(result.output.substr(0, line_end)), std::stoi(result.output.substr(line_end)));
}

TEST(Program, ItsEndCanBeWaitedForAndAskedFor) {
  using std::chrono::milliseconds;
  Program program({"sleep", "1000"});
  EXPECT_FALSE(program.finish_within(milliseconds(20)));
  program.terminate();
  std::optional<ProgramResult> result;
  while (!result) result = program.finish_within(milliseconds(20));
  EXPECT_EQ(result->exit_code, 128 + SIGTERM);
}

TEST(Program, MissingProgramIsNamedWithTheCure) {
  try {
    run_program({"thinwall-no-such-program"});
    FAIL();
  } catch (const PictureFailure& failure) {
    EXPECT_STREQ(failure.what(),
                 "cannot start the program thinwall-no-such-program: No such file or directory; install it (on Debian: "
                 "apt-get install ffmpeg)");
  }
}

TEST(Program, IsKilledWhenNobodyWaitsForIt) {
  const Program program({"sleep", "1000"});
}

}  // namespace
}  // namespace thinwall
