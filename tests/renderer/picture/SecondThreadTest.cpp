#include "renderer/picture/SecondThread.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace thinwall {
namespace {

std::string failure_of(SecondThread& thread, const char* here, const char* beside) {
  const auto fail = [](const char* words) {
    if (words != nullptr) throw std::runtime_error(words);
  };
  try {
    thread.share([&] { fail(here); }, [&] { fail(beside); });
  } catch (const std::runtime_error& failure) {
    return failure.what();
  }
  return "";
}

TEST(SecondThread, DoesOnePartHereAndTheOtherElsewhereAndWaitsForBoth) {
  SecondThread thread;
  for (int turn = 0; turn < 1000; ++turn) {
    std::thread::id here, beside;
    thread.share([&] { here = std::this_thread::get_id(); }, [&] { beside = std::this_thread::get_id(); });
    ASSERT_EQ(here, std::this_thread::get_id());
    ASSERT_NE(beside, std::thread::id());
    ASSERT_NE(beside, here);
  }
}

TEST(SecondThread, LetsThroughWhatEitherPartThrowsAndGoesOn) {
  SecondThread thread;
  EXPECT_EQ(failure_of(thread, nullptr, "beside"), "beside");
  EXPECT_EQ(failure_of(thread, "here", nullptr), "here");
  EXPECT_EQ(failure_of(thread, "here", "beside"), "here");
  EXPECT_EQ(failure_of(thread, nullptr, nullptr), "");
}

}  // namespace
}  // namespace thinwall
