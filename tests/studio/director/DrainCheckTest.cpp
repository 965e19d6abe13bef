#include "studio/director/DrainCheck.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "studio/scenario/InputError.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

/// At rest, with an orifice between them or without.
Body settled_balls(bool has_orifice) {
  BodyDefinition definition = two_balls();
  if (has_orifice) definition.fluid.orifices = {{.from = 0, .to = 1, .area = 1e-6}};
  Body body(definition, {}, quasi_static());
  body.settle();
  return body;
}

/// What is said of clips that drain the chambers one after the other, metres^3; empty when nothing is.
std::string told_of_draining(const Body& body, double large, double small) {
  const std::vector<Clip> timeline(2);
  std::vector<ScheduledClip> clips;
  for (const auto& [chamber, name, drained] : {std::tuple(0, "large", large), std::tuple(1, "small", small)}) {
    const FillClip clip{.body = "balls", .chamber = name, .added = -drained, .drains = true};
    clips.push_back({.plan = FillPlan{.clip = clip, .chamber = chamber}, .begin = static_cast<double>(chamber)});
  }
  try {
    refuse_overdrawn(timeline, clips, [&](const std::string&) -> const Body& { return body; });
  } catch (const InputErrors& refusal) {
    return refusal.what();
  }
  return "";
}

TEST(DrainCheck, OfChambersByThemselvesEachGivesWhatItHolds) {
  const Body balls = settled_balls(false);
  const Eigen::VectorXd& held = balls.state().fluid_volume;
  EXPECT_EQ(told_of_draining(balls, 0.9 * held[0], 0.9 * held[1]), "");
  const std::string told = told_of_draining(balls, 1.1 * held[0], 0.9 * held[1]);
  EXPECT_NE(told.find("chamber `large` of body `balls` holds"), std::string::npos) << told;
}

TEST(DrainCheck, ChambersThatOrificesJoinGiveWhatTheyHoldTogether) {
  const Body balls = settled_balls(true);
  const Eigen::VectorXd& held = balls.state().fluid_volume;
  EXPECT_EQ(told_of_draining(balls, 1.1 * held[0], 0.5 * held[1]), "");
  const std::string told = told_of_draining(balls, 1.1 * held[0], held[1]);
  EXPECT_NE(told.find("that body `balls` holds"), std::string::npos) << told;
}

}  // namespace
}  // namespace thinwall
