#include "studio/recorder/PairedSource.hpp"

#include <gtest/gtest.h>

#include "studio/recorder/FrameComposer.hpp"
#include "tests/studio/SyntheticRun.hpp"

namespace thinwall {
namespace {

std::unique_ptr<MomentSource> pair_of(SyntheticRunOptions first, SyntheticRunOptions second) {
  return pair_sources(std::make_unique<SyntheticRun>(first), std::make_unique<SyntheticRun>(second));
}

TEST(PairedSource, EqualStepsArePairedToTheLastBit) {
  const auto pair = pair_of({}, {.depth = 0.002});
  const SyntheticRun shallow({.depth = 0.002});
  std::size_t step = 0;
  while (const auto moment = pair->next()) {
    ASSERT_TRUE(moment->second);
    EXPECT_EQ(moment->second->snapshot.time, moment->snapshot.time);
    EXPECT_EQ(moment->second->snapshot.surfaces[0].positions, shallow.moment(step).snapshot.surfaces[0].positions);
    EXPECT_EQ(moment->second->record.tools[0].depth, shallow.moment(step).record.tools[0].depth);
    ++step;
  }
  EXPECT_EQ(step, 41U);
  EXPECT_NE(pair->second_state_digest(), pair->state_digest());
}

/// As a take tells it whose recording had shown a pair.
class RecordedFirst final : public MomentSource {
 public:
  std::optional<Moment> next() override { return std::nullopt; }
  std::vector<std::string> warnings() const override {
    return {"the first is recorded", "the second take: the sheet is a formula"};
  }
  std::string state_digest() const override { return ""; }
};

TEST(PairedSource, WhatARecordedFirstTakeTellsOfTheSecondIsToldOnce) {
  const std::vector<std::string> both = {"the sheet is a formula", "the second take: the sheet is a formula"};
  EXPECT_EQ(pair_of({}, {})->warnings(), both);
  const auto replayed = pair_sources(std::make_unique<RecordedFirst>(), std::make_unique<SyntheticRun>());
  EXPECT_EQ(replayed->warnings(), RecordedFirst().warnings());
}

TEST(PairedSource, OtherStepsAreMetBetweenTheirNeighbours) {
  const auto pair = pair_of({}, {.time_step = 0.008, .steps = 26});
  const SyntheticRun coarse({.time_step = 0.008, .steps = 26});
  std::optional<Moment> moment;
  for (int step = 0; step <= 4; ++step) moment = pair->next();
  // 20 ms lie in the middle between 16 and 24.
  const double mean = 0.5 * (coarse.moment(2).snapshot.tools[0].depth + coarse.moment(3).snapshot.tools[0].depth);
  EXPECT_NEAR(moment->second->snapshot.time, 0.020, 1e-12);
  EXPECT_NEAR(moment->second->snapshot.tools[0].depth, mean, 1e-15);
}

TEST(PairedSource, ATakeThatEndsEarlierStaysAsItIsAndOneThatIsLongerIsCutOff) {
  const auto pair = pair_of({}, {.steps = 11});
  std::optional<Moment> last;
  while (auto moment = pair->next()) last = std::move(moment);
  EXPECT_NEAR(last->snapshot.time, 0.2, 1e-12);
  EXPECT_NEAR(last->second->snapshot.time, 0.05, 1e-12);
  const auto other = pair_of({.steps = 11}, {});
  int steps = 0;
  while (other->next()) ++steps;
  EXPECT_EQ(steps, 11);
}

TEST(PairedSource, AFrameHasBothTakesAtItsTimeAndBothForces) {
  const auto pair = pair_of({}, {.depth = 0.002});
  ViewDefinition view;
  view.comparison = std::make_shared<const TakeComparison>(TakeComparison{{"deep", "shallow"}, {}});
  FrameComposer composer("A sheet", {}, view);
  for (int step = 0; step <= 8; ++step) composer.add(*pair->next());
  const Frame frame = composer.compose(0.0375);
  ASSERT_TRUE(frame.shot.beside_snapshot);
  EXPECT_DOUBLE_EQ(frame.shot.beside_snapshot->time, 0.0375);
  EXPECT_NEAR(frame.shot.beside_snapshot->tools[0].depth, 0.5 * frame.snapshot.tools[0].depth, 1e-15);
  EXPECT_EQ(frame.overlay.half_captions[1], "shallow");
  ASSERT_EQ(frame.overlay.other_history.size(), 8U);
  EXPECT_NEAR(frame.overlay.other_history[7].force, 0.5 * frame.overlay.history[7].force, 1e-12);
}

TEST(PairedSource, EachHalfHasTheLegendOfItsOwnData) {
  const DataView strain{.quantity = DataQuantity::kStrain, .from = 0, .to = 0.3};
  const DataView thickness{.quantity = DataQuantity::kThickness, .from = 0, .to = 0.002};
  const auto overlay_of = [](std::optional<DataView> left, std::optional<DataView> right) {
    const auto pair = pair_of({}, {});
    TakeComparison comparison{{"left", "right"}, {}};
    comparison.second.look.data = right;
    ViewDefinition view;
    view.look.data = left;
    view.comparison = std::make_shared<const TakeComparison>(comparison);
    FrameComposer composer("A sheet", {}, view);
    composer.add(*pair->next());
    return composer.compose(0).overlay;
  };
  using Titles = std::pair<std::string, std::string>;  // of the left and the right legend
  const auto titles = [&](std::optional<DataView> left, std::optional<DataView> right) -> Titles {
    const OverlayContent overlay = overlay_of(left, right);
    return {overlay.left_legend ? overlay.left_legend->title : "", overlay.legend ? overlay.legend->title : ""};
  };
  EXPECT_EQ(titles({}, strain), Titles("", "Largest strain"));
  EXPECT_EQ(titles(strain, {}), Titles("Largest strain", "")) << "the right half shows tissue";
  EXPECT_EQ(titles(strain, thickness), Titles("Largest strain", "Thickness"));
  EXPECT_EQ(titles(strain, strain), Titles("", "Largest strain")) << "one for both";
  EXPECT_TRUE(overlay_of({}, strain).legend_is_of_the_right) << "the left half has no use for it";
  EXPECT_FALSE(overlay_of(strain, strain).legend_is_of_the_right);
}

}  // namespace
}  // namespace thinwall
