// The books of energy close along a whole palpation: what the tool put in is stored or was spent by the integrator.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

struct Palpation {
  const char* name;
  ToolDefinition tool;
  Analysis analysis;
  FluidKind fluid;
};

void PrintTo(const Palpation& palpation, std::ostream* out) {
  *out << palpation.name;
}

std::vector<Palpation> palpations() {
  std::vector<Palpation> all;
  for (const Analysis analysis : {Analysis::kQuasiStatic, Analysis::kDynamic}) {
    const bool still = analysis == Analysis::kQuasiStatic;
    for (const FluidKind fluid : {FluidKind::kIncompressible, FluidKind::kCompressible}) {
      all.push_back({still ? "StillPoint" : "MovingPoint", point_tool(), analysis, fluid});
      all.push_back({still ? "StillLine" : "MovingLine", line_tool(8e-3), analysis, fluid});
      all.push_back({still ? "StillSphere" : "MovingSphere", sphere_tool(5e-3), analysis, fluid});
    }
  }
  return all;
}

constexpr double kTop = 23e-3, kDeep = 18e-3;  // metres

Body make_palpated(const Palpation& palpation) {
  BodyDefinition definition = pressurised_hemisphere(256, 300);
  definition.fluid.kind = palpation.fluid;
  definition.fluid.bulk_modulus = 50e3;
  SimulationOptions options;
  options.analysis = palpation.analysis;
  Body body(definition, {palpation.tool}, options);
  body.settle();
  return body;
}

/// Down, hold and back up at 100 mm/s; gives the numbers of the books on the way.
struct Books {
  double worst_imbalance = 0;  // joule
  double largest = 0;          // joule, of all terms
  double numerical = 0;        // joule, largest on the way
  double tool_work = 0;        // joule, largest on the way
};

Books palpate(Body& body, int steps) {
  Books result;
  const auto note = [&](const ToolPose&) {
    const EnergyBooks& books = body.state().books;
    result.worst_imbalance = std::max(result.worst_imbalance, std::abs(books.imbalance()));
    for (const double term : {books.elastic, books.kinetic, books.fluid, books.contact, books.tool_work}) {
      result.largest = std::max(result.largest, std::abs(term));
    }
    result.numerical = std::max(result.numerical, std::abs(books.numerical));
    result.tool_work = std::max(result.tool_work, books.tool_work);
  };
  const double duration = 0.05 / steps;
  ToolPose pose = move(body, pose_at({1.1e-3, 0.7e-3, kTop}), {1.1e-3, 0.7e-3, kDeep}, steps, duration, note);
  pose = move(body, pose, pose.tip, steps / 2, duration, note);
  move(body, pose, {1.1e-3, 0.7e-3, kTop}, steps, duration, note);
  return result;
}

class EnergyBooksOf : public testing::TestWithParam<Palpation> {};

TEST_P(EnergyBooksOf, CloseOverPressingHoldAndWithdrawal) {
  Body body = make_palpated(GetParam());
  const Books books = palpate(body, 20);
  std::printf("imbalance / largest term %.1e, numerical / tool work %.1e, tool work %.2e J\n",
              books.worst_imbalance / books.largest, books.numerical / books.tool_work, books.tool_work);
  EXPECT_GT(books.tool_work, 1e-5);  // the tool did press
  EXPECT_LT(books.worst_imbalance, 1e-9 * books.largest);
}

TEST_P(EnergyBooksOf, ChargeTheIntegratorWithLittle) {
  // Otherwise books that close would say nothing: what does not fit would go to the integrator's account.
  Body coarse_body = make_palpated(GetParam()), fine_body = make_palpated(GetParam());
  const Books coarse = palpate(coarse_body, 10), fine = palpate(fine_body, 40);
  std::printf("numerical / tool work: %.1e, with steps of a quarter %.1e\n", coarse.numerical / coarse.tool_work,
              fine.numerical / fine.tool_work);
  if (GetParam().analysis == Analysis::kQuasiStatic) {
    // The trapezoidal rule is of second order: 16 in smooth parts; seen 10 to 18.
    EXPECT_LT(fine.numerical, coarse.numerical / 8);
    EXPECT_LT(fine.numerical, 2e-3 * fine.tool_work);
  } else {
    // Tools that hit and leave at 100 mm/s bring masses to their speed in an instant, which costs energy at any step.
    EXPECT_LT(fine.numerical, 0.1 * fine.tool_work);
    EXPECT_LT(coarse.numerical, 0.1 * coarse.tool_work);
  }
}

INSTANTIATE_TEST_SUITE_P(Tools, EnergyBooksOf, testing::ValuesIn(palpations()), [](const auto& each) {
  return std::string(each.param.name) +
         (each.param.fluid == FluidKind::kIncompressible ? "Incompressible" : "Compressible");
});

/// What a rod pressed 3 mm into the top does when it is then tilted by a third of a radian, joule.
struct Tilt {
  double tool_work = 0;
  double numerical = 0;  // largest on the way
};

Tilt tilt_pressed_rod(int steps) {
  const ToolDefinition rod{.name = "rod", .kind = ToolKind::kCapsule, .length = 16e-3, .radius = 3e-3};
  Body body(pressurised_hemisphere(256, 300), {rod}, quasi_static());
  body.settle();
  ToolPose pose = move(body, pose_at({1.1e-3, 0.7e-3, kTop}), {1.1e-3, 0.7e-3, 17e-3}, 10, 0.01);
  const EnergyBooks before = body.state().books;
  Tilt tilt;
  for (int step = 1; step <= steps; ++step) {
    const double angle = step / (3.0 * steps);
    ToolPose next = pose;
    next.direction = {0, std::sin(angle), -std::cos(angle)};
    next.axis = {0, std::cos(angle), std::sin(angle)};
    body.advance(std::vector{pose}, std::vector{next}, 0.01);
    pose = next;
    const EnergyBooks& books = body.state().books;
    tilt.tool_work = books.tool_work - before.tool_work;
    tilt.numerical = std::max(tilt.numerical, std::abs(books.numerical - before.numerical));
  }
  return tilt;
}

TEST(EnergyBooks, ATurningToolIsChargedWithTheWorkOfItsMoment) {
  const Tilt coarse = tilt_pressed_rod(5), fine = tilt_pressed_rod(20);
  std::printf("tilting takes %.2e J, numerical %.1e J, with steps of a quarter %.1e J\n", fine.tool_work,
              coarse.numerical, fine.numerical);
  EXPECT_GT(fine.tool_work, 1e-5);
  EXPECT_LT(fine.numerical, 2e-3 * fine.tool_work);
  EXPECT_LT(fine.numerical, coarse.numerical / 8);
}

}  // namespace
}  // namespace thinwall
