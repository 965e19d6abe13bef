// Two strips in series that differ by region: the joint stands where the closed form has it.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "studio/director/ScenarioRun.hpp"
#include "studio/scenario/LoadScenario.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

constexpr double kThick = 1, kThin = 0.4, kPrestretch = 1.3;
constexpr double kHalf = 20;  // mm, length of each strip

/// The joint's x, mm, where both strips bear the same force: P h with P = mu (a - a^-3 b^-2), stretches a along and b
/// across, of a neo-Hookean strip that is held in its width.
double joint_in_closed_form() {
  const auto force = [](double thickness, double a) {
    return thickness * (a - 1 / (a * a * a * kPrestretch * kPrestretch));
  };
  double low = 0.5, high = 2 * kPrestretch - 0.5;  // stretch of the thick strip
  for (int i = 0; i < 200; ++i) {
    const double a = (low + high) / 2;
    (force(kThick, a) < force(kThin, 2 * kPrestretch - a) ? low : high) = a;
  }
  return kHalf * (low / kPrestretch - 1);
}

class StripsByField : public testing::Test {
 protected:
  /// The x of the joint, mm.
  double run(const std::string& thickness, const std::string& modulus = "20 kPa",
             const std::string& prestretch = "1.3") const {
    write_bytes(folder_ / "scene.yaml",
                "thinwall: 1\n"
                "bodies:\n"
                "  strip:\n"
                "    surface: { shape: strip, width: 40 mm, length: 10 mm, triangles: 200 }\n"
                "    wall:\n"
                "      thickness: " +
                    thickness +
                    "\n"
                    "      material: { law: neo_hookean, shear_modulus: " +
                    modulus +
                    " }\n"
                    "      prestretch: " +
                    prestretch +
                    "\n"
                    "    contents: { fluid: none }\n"
                    "    fixed:\n"
                    "      - { region: { plane: { axis: z, at: 0 } }, axes: yz }\n"
                    "      - { region: { below: { axis: x, at: -20 mm } } }\n"
                    "      - { region: { above: { axis: x, at: 20 mm } } }\n"
                    "timeline: [ { wait: { for: 10 ms } } ]\n"
                    "simulation: { analysis: quasi_static, time_step: 10 ms }\n"
                    "record: { points: { joint: { body: strip, at: [0, 0, 0] } } }\n");
    ScenarioRun run(load_scenario(folder_ / "scene.yaml", {}));
    const auto& surface = run.snapshot().surfaces.at(0);
    double joint = NAN;  // all of its vertices have one x
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const auto& rest = surface.topology->rest_positions[v];
      if (std::abs(rest[0]) < 1e-9) joint = 1e3 * static_cast<double>(surface.positions[v][0]);
    }
    return joint;
  }

  TemporaryFolder folder_;
};

const std::string kByRegion = "{ default: 1 mm, regions: [ { in: { above: { axis: x, at: 0 } }, value: 0.4 mm } ] }";

TEST_F(StripsByField, TheJointStandsWhereTheClosedFormHasIt) {
  // The snapshot's positions are in single precision: 20 mm to 2e-6 mm.
  EXPECT_NEAR(run(kByRegion), joint_in_closed_form(), 5e-6);
  EXPECT_GT(std::abs(joint_in_closed_form()), 1);
}

TEST_F(StripsByField, PrestretchByDirectionAndRegionMovesTheJoint) {
  // Strips of one thickness and one stretch across come to the same stretch along; their rest lengths are 20 mm / 1.4
  // and 20 mm / 1.2.
  const std::string prestretch =
      "{ default: { along: [1, 0, 0], values: [1.4, 1.1] }, regions: [ { in: { above: { axis: x, at: 0 } }, "
      "value: { along: [0, 2, 0], values: [1.1, 1.2] } } ] }";
  const double stretch = 2 / (1 / 1.4 + 1 / 1.2);
  EXPECT_NEAR(run("1 mm", "20 kPa", prestretch), kHalf * (stretch / 1.4 - 1), 5e-6);
}

TEST_F(StripsByField, AModulusByRegionDrawsTheStripsAsTheThicknessDoes) {
  const std::string modulus = "{ default: 20 kPa, regions: [ { in: { above: { axis: x, at: 0 } }, value: 8 kPa } ] }";
  EXPECT_NEAR(run("1 mm", modulus), joint_in_closed_form(), 5e-6);
}

}  // namespace
}  // namespace thinwall
