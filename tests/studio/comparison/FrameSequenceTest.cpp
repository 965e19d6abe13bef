#include "studio/comparison/FrameSequence.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

TEST(FrameSequenceTest, OfOneLengthThereIsNothingToTell) {
  EXPECT_EQ(length_difference({"a", "b"}, {"a", "c"}), "");
}

TEST(FrameSequenceTest, MissingFramesAreNamedWhereAllOthersAreTheSame) {
  EXPECT_EQ(length_difference({"a", "b", "c", "d"}, {"a", "c", "d"}),
            "3 frames instead of 4: frame 1 is missing, all others are equal");
  EXPECT_EQ(length_difference({"a", "b", "c", "d"}, {"a", "d"}),
            "2 frames instead of 4: frames 1 to 2 are missing, all others are equal");
}

TEST(FrameSequenceTest, NewFramesAreNamedWhereAllOthersAreTheSame) {
  EXPECT_EQ(length_difference({"a", "c"}, {"a", "b", "c"}),
            "3 frames instead of 2: frame 1 is new, all others are equal");
  EXPECT_EQ(length_difference({"c"}, {"a", "b", "c"}),
            "3 frames instead of 1: frames 0 to 1 at the beginning are new, all others are equal");
  EXPECT_EQ(length_difference({"a", "b"}, {"a", "b", "c"}),
            "3 frames instead of 2: frame 2 at the end is new, all others are equal");
}

TEST(FrameSequenceTest, WhereOthersDifferTooOnlyTheNumbersAreTold) {
  EXPECT_EQ(length_difference({"a", "b", "c"}, {"x", "y"}), "2 frames instead of 3");
}

}  // namespace
}  // namespace thinwall
