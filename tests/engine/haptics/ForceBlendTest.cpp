#include "engine/haptics/ForceBlend.hpp"

#include <gtest/gtest.h>

namespace thinwall {
namespace {

const Eigen::Vector3d kOld(1, 2, 3), kNew(2, -2, 5);  // newton

TEST(ForceBlendTest, BeginsAtWhatWasGivenAndEndsAtTheNewModel) {
  ForceBlend blend(4e-3);
  blend.take_over(1, kOld, kNew);
  EXPECT_TRUE(blend.force(1, kNew).isApprox(kOld));
  EXPECT_TRUE(blend.force(1.004, kNew).isApprox(kNew));
  EXPECT_TRUE(blend.force(1.5, kNew).isApprox(kNew));
}

TEST(ForceBlendTest, NoStepIsLargerThanTheSteepestSlopeAsks) {
  ForceBlend blend(4e-3);
  blend.take_over(0, kOld, kNew);
  Eigen::Vector3d before = kOld;
  for (double time = 0; time <= 5e-3; time += 1e-4) {
    const Eigen::Vector3d force = blend.force(time, kNew);
    // 1 - 3 s^2 + 2 s^3 falls by 3/2 per unit of s at most.
    EXPECT_LE((force - before).norm(), 1.5 * (1e-4 / 4e-3) * (kNew - kOld).norm() * (1 + 1e-9));
    before = force;
  }
}

TEST(ForceBlendTest, AModelThatTakesOverWithinABlendGoesOnFromWhatWasGiven) {
  ForceBlend blend(4e-3);
  blend.take_over(0, kOld, kNew);
  const Eigen::Vector3d given = blend.force(2e-3, kNew), newest(0, 0, 9);
  blend.take_over(2e-3, given, newest);
  EXPECT_TRUE(blend.force(2e-3, newest).isApprox(given));
}

}  // namespace
}  // namespace thinwall
