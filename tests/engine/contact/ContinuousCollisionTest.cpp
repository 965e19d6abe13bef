#include "engine/contact/ContinuousCollision.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace thinwall {
namespace {

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Eigen::Vector3d vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }

 private:
  std::mt19937 random_;
};

struct Meeting {
  PairCorners corners, motions;
  double time;  // at which the two meet, at the latest
};

/// Random parts that move along random ways and meet at a random time and place.
Meeting draw_meeting(PairKind kind, Draw& draw) {
  Meeting meeting{.corners = {}, .motions = {}, .time = draw.between(0.05, 0.95)};
  PairCorners met;
  for (int k = 0; k < 4; ++k) met[k] = draw.vector();
  if (kind == PairKind::kPointTriangle) {
    Eigen::Vector3d weights(draw.between(0, 1), draw.between(0, 1), draw.between(0, 1));
    weights /= weights.sum();
    met[0] = weights[0] * met[1] + weights[1] * met[2] + weights[2] * met[3];
  } else {
    const double s = draw.between(0, 1), t = draw.between(0.05, 1);
    met[3] = met[2] + (met[0] + s * (met[1] - met[0]) - met[2]) / t;
  }
  for (int k = 0; k < 4; ++k) {
    meeting.motions[k] = draw.between(0.01, 10) * draw.vector();
    meeting.corners[k] = met[k] - meeting.time * meeting.motions[k];
  }
  return meeting;
}

PairCorners moved(const Meeting& meeting, double fraction) {
  PairCorners corners = meeting.corners;
  for (int k = 0; k < 4; ++k) corners[k] += fraction * meeting.motions[k];
  return corners;
}

constexpr PairKind kKinds[] = {PairKind::kPointTriangle, PairKind::kEdgeEdge};

TEST(SafeFraction, NeverPassesAMeeting) {
  Draw draw(11);
  for (const PairKind kind : kKinds) {
    for (int k = 0; k < 5000; ++k) {
      const Meeting meeting = draw_meeting(kind, draw);
      const double fraction = safe_fraction(kind, meeting.corners, meeting.motions);
      ASSERT_LT(fraction, meeting.time);
      ASSERT_GE(fraction, 0);
    }
  }
}

TEST(SafeFraction, KeepsAPartOfTheDistanceAllTheWay) {
  Draw draw(12);
  for (const PairKind kind : kKinds) {
    for (int k = 0; k < 300; ++k) {
      const Meeting meeting = draw_meeting(kind, draw);
      const double fraction = safe_fraction(kind, meeting.corners, meeting.motions);
      const double before = pair_distance(kind, meeting.corners).distance;
      for (int step = 0; step <= 50; ++step) {
        const double distance = pair_distance(kind, moved(meeting, fraction * step / 50)).distance;
        ASSERT_GT(distance, 0.999 * kKeptDistance * before);
      }
    }
  }
}

TEST(SafeFraction, OfPartsThatDoNotComeNearIsWhole) {
  Draw draw(13);
  for (const PairKind kind : kKinds) {
    for (int k = 0; k < 300; ++k) {
      PairCorners corners = {draw.vector(), draw.vector(), draw.vector(), draw.vector()};
      // A motion in common, however long, brings nothing nearer.
      const Eigen::Vector3d all = 1e3 * draw.vector();
      EXPECT_EQ(safe_fraction(kind, corners, {all, all, all, all}), 1);
    }
  }
}

TEST(SafeFraction, ComesCloseToAHeadOnMeeting) {
  const PairCorners corners = {Eigen::Vector3d(0.2, 0.2, 1), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                               Eigen::Vector3d(0, 1, 0)};
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  const double fraction =
      safe_fraction(PairKind::kPointTriangle, corners, {Eigen::Vector3d(0, 0, -2), still, still, still});
  EXPECT_LT(fraction, 0.5);
  EXPECT_GT(fraction, 0.44);  // 0.45 keeps a tenth of the distance
}

TEST(SafeFraction, LetsThroughWhatMissesNarrowly) {
  // The point passes the corner at a distance of a hundredth.
  const PairCorners corners = {Eigen::Vector3d(-0.01, 0, 0.02), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                               Eigen::Vector3d(0, 1, 0)};
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  EXPECT_EQ(safe_fraction(PairKind::kPointTriangle, corners, {Eigen::Vector3d(0, 0, -1), still, still, still}), 1);
}

}  // namespace
}  // namespace thinwall
