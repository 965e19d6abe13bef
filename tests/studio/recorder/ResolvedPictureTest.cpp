#include "studio/recorder/ResolvedPicture.hpp"

#include <gtest/gtest.h>

#include "studio/scenario/LoadScenario.hpp"
#include "studio/take/TakeError.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

constexpr const char* kScenario = R"(thinwall: 1
bodies:
  organ:
    surface: { shape: sphere, radius: 20 mm, triangles: 320 }
    wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 20 kPa } }
)";
constexpr const char* kPicture = R"(
camera: { position: [80 mm, -60 mm, 50 mm], target: [1 mm, 2 mm, 3 mm], up: [0, 1, 0], field_of_view: 40 deg, orbit_speed: 10 deg/s }
lights: { key: 0.9, fill: 0.8, environment: 0.7, key_direction: [0, 0, 2] }
look:
  background: [0.1, 0.2, 0.3]
  ground: drape
  bodies: { organ: { organ: liver, color: [0.4, 0.5, 0.6], roughness: 0.3, wetness: 0.2, contents: bile, bleeding: 0.3 } }
  overlays: { force_plot: false, gauge: false, captions: false, time: false }
  data: { shows: thickness, from: 1 mm, to: 2 mm, scale: root, legend: lower_left }
record: { size: [320, 200], fps: 25, video: false, tier: final }
)";

class ResolvedPictureTest : public ::testing::Test {
 protected:
  void expect_the_same_from_the_take(const std::string& scenario_text) {
    const TemporaryFolder folder;
    write_bytes(folder / "s.yaml", scenario_text);
    const Scenario scenario = load_scenario(folder / "s.yaml", {});
    const PictureSettings read = picture_settings(scenario.resolved);
    const CameraDefinition& camera = scenario.view.camera;
    EXPECT_EQ(read.view.camera.position, camera.position);
    EXPECT_EQ(read.view.camera.target, camera.target);
    EXPECT_EQ(read.view.camera.up, camera.up);
    EXPECT_EQ(read.view.camera.field_of_view, camera.field_of_view);
    EXPECT_EQ(read.view.camera.orbit_speed, camera.orbit_speed);
    EXPECT_EQ(read.view.camera.kind, camera.kind);
    EXPECT_EQ(read.view.camera.exposure, camera.exposure);
    EXPECT_EQ(read.view.lights.endoscope, scenario.view.lights.endoscope);
    EXPECT_EQ(read.view.lights.key, scenario.view.lights.key);
    EXPECT_EQ(read.view.lights.fill, scenario.view.lights.fill);
    EXPECT_EQ(read.view.lights.environment, scenario.view.lights.environment);
    EXPECT_EQ(read.view.lights.key_direction, scenario.view.lights.key_direction);
    EXPECT_EQ(read.view.look.background, scenario.view.look.background);
    EXPECT_EQ(read.view.look.ground, scenario.view.look.ground);
    EXPECT_EQ(read.view.look.data.has_value(), scenario.view.look.data.has_value());
    if (const auto& data = scenario.view.look.data; data && read.view.look.data) {
      EXPECT_EQ(read.view.look.data->quantity, data->quantity);
      EXPECT_EQ(read.view.look.data->from, data->from);
      EXPECT_EQ(read.view.look.data->to, data->to);
      EXPECT_EQ(read.view.look.data->scale, data->scale);
      EXPECT_EQ(read.view.look.data->legend, data->legend);
    }
    ASSERT_EQ(read.view.look.bodies.size(), scenario.view.look.bodies.size());
    for (const auto& [name, look] : scenario.view.look.bodies) {
      EXPECT_EQ(read.view.look.bodies.at(name).color, look.color);
      EXPECT_EQ(read.view.look.bodies.at(name).roughness, look.roughness);
      EXPECT_EQ(read.view.look.bodies.at(name).wetness, look.wetness);
      EXPECT_EQ(read.view.look.bodies.at(name).contents.color, look.contents.color);
      EXPECT_EQ(read.view.look.bodies.at(name).contents.clarity, look.contents.clarity);
      EXPECT_EQ(read.view.look.bodies.at(name).bleeding, look.bleeding);
      EXPECT_EQ(read.view.look.bodies.at(name).blood, look.blood);
    }
    EXPECT_EQ(read.overlays, scenario.overlays);
    EXPECT_EQ(read.record.size, scenario.record.size);
    EXPECT_EQ(read.record.frames_per_second, scenario.record.frames_per_second);
    EXPECT_EQ(read.record.tier, scenario.record.tier);
  }
};

TEST_F(ResolvedPictureTest, DefaultsComeBackFromTheTake) {
  expect_the_same_from_the_take(kScenario);
}

TEST_F(ResolvedPictureTest, EachSettingComesBackFromTheTake) {
  expect_the_same_from_the_take(std::string(kScenario) + kPicture);
}

TEST_F(ResolvedPictureTest, AnEndoscopeComesBackFromTheTake) {
  expect_the_same_from_the_take(std::string(kScenario) + "camera: { kind: endoscope, exposure: 0.5 }\n");
  expect_the_same_from_the_take(std::string(kScenario) + "lights: { endoscope: 2 }\n");
}

TEST_F(ResolvedPictureTest, AnOrganThatIsNotKnownIsRefused) {
  const TemporaryFolder folder;
  write_bytes(folder / "s.yaml", kScenario);
  std::string resolved = load_scenario(folder / "s.yaml", {}).resolved;
  const std::size_t place = resolved.find("\"tissue\"");
  ASSERT_NE(place, std::string::npos);
  resolved.replace(place, 8, "\"gizzard\"");
  EXPECT_THROW(picture_settings(resolved), TakeError);
}

TEST_F(ResolvedPictureTest, ATakeOfBeforeThereWereGroundsNamesNoneAndUnknownOnesAreRefused) {
  const TemporaryFolder folder;
  write_bytes(folder / "s.yaml", std::string(kScenario) + kPicture);
  const std::string resolved = load_scenario(folder / "s.yaml", {}).resolved;
  const std::string words = R"("ground": "drape")";
  const std::size_t place = resolved.find(words);
  ASSERT_NE(place, std::string::npos) << resolved;
  std::string before = resolved, later = resolved;
  before.replace(place, words.size(), R"("other": "drape")");
  EXPECT_FALSE(picture_settings(before).view.look.ground);
  later.replace(place, words.size(), R"("ground": "grass")");
  EXPECT_THROW(picture_settings(later), TakeError);
}

TEST_F(ResolvedPictureTest, ADataViewOfBeforeThereWereScalesIsLinearAndUnknownScalesAreRefused) {
  const TemporaryFolder folder;
  write_bytes(folder / "s.yaml", std::string(kScenario) + kPicture);
  const std::string resolved = load_scenario(folder / "s.yaml", {}).resolved;
  const std::string words = R"("scale": "root")";
  const std::size_t place = resolved.find(words);
  ASSERT_NE(place, std::string::npos) << resolved;
  std::string before = resolved, later = resolved;
  before.replace(place, words.size(), R"("other": "root")");
  EXPECT_EQ(picture_settings(before).view.look.data.value().scale, DataScale::kLinear);
  later.replace(place, words.size(), R"("scale": "cube")");
  EXPECT_THROW(picture_settings(later), TakeError);
}

TEST_F(ResolvedPictureTest, ATakeWithoutAScenarioIsRefused) {
  EXPECT_THROW(picture_settings(std::string("{}")), TakeError);
  EXPECT_THROW(picture_settings(std::string("no json")), TakeError);
}

}  // namespace
}  // namespace thinwall
