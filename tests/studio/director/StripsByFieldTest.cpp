// Two strips in series, told apart by a region, by a table beside the mesh file
// and by properties of the mesh file: one and the same body, whose joint stands
// where the closed form has it.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "studio/director/ScenarioRun.hpp"
#include "studio/scenario/LoadScenario.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

constexpr int kColumns = 20, kRows = 4;  // squares of 2 mm, two triangles each;
                                         // the joint is in the middle
constexpr double kThick = 1, kThin = 0.4, kPrestretch = 1.3;
constexpr double kHalf = 20;  // mm, length of each strip

/// The joint's x, mm, where both strips bear the same force: P h with P = mu (a
/// - a^-3 b^-2), stretches a along and b across, of a neo-Hookean strip that is
/// held in its width.
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

/// Numbers of the strips in the order of the mesh file: `per_vertex` with the
/// joint's vertices there twice.
struct StripFiles {
  std::string ply, per_face, per_vertex;
};

StripFiles strip_files() {
  const int left = kColumns / 2 + 1;  // columns of vertices of each strip
  std::string vertices, faces;
  StripFiles files{.ply = "", .per_face = "face, thickness, modulus\n", .per_vertex = "thickness\n"};
  int face = 0;
  for (const int side : {0, 1}) {
    const std::string thickness = side == 0 ? "1" : "0.4";
    const std::string modulus = side == 0 ? "20" : "8";
    const int first = side * left * (kRows + 1);
    for (int i = 0; i < left; ++i) {
      for (int j = 0; j <= kRows; ++j) {
        const int x = 2 * (i + side * (left - 1)) - static_cast<int>(kHalf);
        vertices += std::to_string(x) + " " + std::to_string(2 * j - kRows) + " 0 " + thickness + "\n";
        files.per_vertex += thickness + "\n";
        if (i == 0 || j == 0) continue;
        const int v = first + i * (kRows + 1) + j, below = v - kRows - 1;
        for (const auto& corners : {std::array{below - 1, v - 1, v}, std::array{below - 1, v, below}}) {
          faces += "3 " + std::to_string(corners[0]) + " " + std::to_string(corners[1]) + " " +
                   std::to_string(corners[2]) + " " + thickness + "\n";
          files.per_face += std::to_string(++face) + ", " + thickness + ", " + modulus + "\n";
        }
      }
    }
  }
  files.ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(2 * left * (kRows + 1)) +
              "\nproperty float x\nproperty float y\nproperty float "
              "z\nproperty float thickness\nelement face " +
              std::to_string(face) +
              "\nproperty list uchar int vertex_indices\nproperty float "
              "face_thickness\nend_header\n" +
              vertices + faces;
  return files;
}

struct RunResult {
  std::string digest;
  double joint;  // mm
};

class StripsByField : public testing::Test {
 protected:
  StripsByField() {
    const StripFiles files = strip_files();
    write_bytes(folder_ / "strip.ply", files.ply);
    write_bytes(folder_ / "faces.csv", files.per_face);
    write_bytes(folder_ / "vertices.csv", files.per_vertex);
  }

  RunResult run(const std::string& thickness, const std::string& modulus = "20 kPa",
                const std::string& prestretch = "1.3") const {
    write_bytes(folder_ / "scene.yaml",
                "thinwall: 1\n"
                "bodies:\n"
                "  strip:\n"
                "    surface: { mesh: strip.ply, unit: mm }\n"
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
    return {run.state_digest(), joint};
  }

  TemporaryFolder folder_;
};

const std::string kByRegion =
    "{ default: 1 mm, regions: [ { in: { above: { "
    "axis: x, at: 0 } }, value: 0.4 mm } ] }";

TEST_F(StripsByField, TheJointStandsWhereTheClosedFormHasIt) {
  // The snapshot's positions are in single precision: 20 mm to 2e-6 mm.
  EXPECT_NEAR(run(kByRegion).joint, joint_in_closed_form(), 5e-6);
  EXPECT_GT(std::abs(joint_in_closed_form()), 1);
}

TEST_F(StripsByField, PrestretchByDirectionAndRegionMovesTheJoint) {
  // Strips of one thickness and one stretch across come to the same stretch
  // along; their rest lengths are 20 mm / 1.4 and 20 mm / 1.2.
  const std::string prestretch =
      "{ default: { along: [1, 0, 0], values: [1.4, 1.1] }, regions: [ { in: { "
      "above: { axis: x, at: 0 } }, "
      "value: { along: [0, 2, 0], values: [1.1, 1.2] } } ] }";
  const double stretch = 2 / (1 / 1.4 + 1 / 1.2);
  EXPECT_NEAR(run("1 mm", "20 kPa", prestretch).joint, kHalf * (stretch / 1.4 - 1), 5e-6);
}

TEST_F(StripsByField, AModulusByRegionDrawsTheStripsAsTheThicknessDoes) {
  const std::string modulus =
      "{ default: 20 kPa, regions: [ { in: { above: { "
      "axis: x, at: 0 } }, value: 8 kPa } ] }";
  EXPECT_NEAR(run("1 mm", modulus).joint, joint_in_closed_form(), 5e-6);
}

TEST_F(StripsByField, RegionTableAndMeshGiveTheSameBytes) {
  const std::string digest = run(kByRegion).digest;
  EXPECT_NE(run("1 mm").digest, digest);
  EXPECT_EQ(run("{ file: faces.csv, column: thickness, unit: mm, per: face }").digest, digest);
  EXPECT_EQ(run("{ attribute: face_thickness, unit: mm }").digest, digest);
}

TEST_F(StripsByField, NumbersOfVerticesKeepAJumpWhereTheFileHasTheVerticesTwice) {
  // The mean of three equal numbers is another one in the last bit.
  const std::string by_vertex = run("{ attribute: thickness, unit: mm }").digest;
  EXPECT_EQ(run("{ file: vertices.csv, column: thickness, unit: mm, per: vertex }").digest, by_vertex);
  EXPECT_NEAR(run("{ attribute: thickness, unit: mm }").joint, joint_in_closed_form(), 5e-6);
}

TEST_F(StripsByField, AModulusByTableDrawsTheStripsAsTheThicknessDoes) {
  const RunResult by_modulus = run("1 mm", "{ file: faces.csv, column: modulus, unit: kPa, per: face }");
  EXPECT_NEAR(by_modulus.joint, joint_in_closed_form(), 5e-6);
}

}  // namespace
}  // namespace thinwall
