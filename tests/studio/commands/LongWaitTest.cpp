#include "studio/commands/LongWait.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace thinwall {
namespace {

TEST(LongWait, TellsAfterFiveSecondsAndEachTimeThatTheyHaveDoubled) {
  std::chrono::steady_clock::time_point now;
  std::vector<std::string> told;
  LongWait wait(
      "finding it", [&](const std::string& note) { told.push_back(note); }, "", [&] { return now; });
  for (int tenth = 0; tenth < 230; ++tenth) {
    wait.look();
    now += std::chrono::milliseconds(100);
  }
  EXPECT_EQ(told, (std::vector<std::string>{"finding it has taken 5 s so far", "finding it has taken 10 s so far",
                                            "finding it has taken 20 s so far"}));
}

TEST(LongWait, EndsWithItsAdvice) {
  std::chrono::steady_clock::time_point now;
  std::string told;
  LongWait wait(
      "finding it", [&](const std::string& note) { told = note; }, "; look elsewhere", [&] { return now; });
  now += std::chrono::seconds(6);
  wait.look();
  EXPECT_EQ(told, "finding it has taken 6 s so far; look elsewhere");
}

TEST(LongWait, TellsOnceOfALookThatComesLate) {
  std::chrono::steady_clock::time_point now;
  int told = 0;
  LongWait wait(
      "finding it", [&](const std::string&) { ++told; }, "", [&] { return now; });
  now += std::chrono::seconds(50);
  wait.look();
  wait.look();
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace thinwall
