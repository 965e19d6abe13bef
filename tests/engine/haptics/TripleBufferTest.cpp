#include "engine/haptics/TripleBuffer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace thinwall {
namespace {

TEST(TripleBufferTest, TheReaderGetsTheLatestWholeValueOnce) {
  TripleBuffer<int> buffer;
  EXPECT_FALSE(buffer.take());
  for (const int value : {1, 2, 3}) {
    buffer.back() = value;
    buffer.publish();
  }
  EXPECT_TRUE(buffer.has_fresh());
  EXPECT_TRUE(buffer.take());
  EXPECT_EQ(buffer.front(), 3);
  EXPECT_FALSE(buffer.take());
  EXPECT_EQ(buffer.front(), 3);
}

TEST(TripleBufferTest, ValuesAreNeverTornAndNeverGoBack) {
  constexpr long kLast = 200'000;
  TripleBuffer<std::array<long, 16>> buffer;
  std::thread writer([&] {
    for (long value = 1; value <= kLast; ++value) {
      buffer.back().fill(value);
      buffer.publish();
    }
  });
  long before = 0, torn = 0, back = 0;
  while (before < kLast) {
    if (!buffer.take()) continue;
    const std::array<long, 16>& value = buffer.front();
    for (const long number : value) torn += number != value[0] ? 1 : 0;
    back += value[0] <= before ? 1 : 0;
    before = value[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(back, 0);
}

}  // namespace
}  // namespace thinwall
