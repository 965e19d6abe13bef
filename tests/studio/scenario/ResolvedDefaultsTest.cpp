#include "studio/scenario/ResolvedDefaults.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "studio/scenario/LoadScenario.hpp"
#include "tests/studio/scenario/ScenarioTestTools.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::json;

const std::filesystem::path kSource = THINWALL_SOURCE_DIR;

Json filled(const Json& json) {
  return Json::parse(with_defaults(json.dump()));
}

TEST(ResolvedDefaults, TodaysScenariosLackNone) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "scenes")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string resolved = load_scenario(entry.path(), {}).resolved;
    EXPECT_EQ(Json::parse(with_defaults(resolved)), Json::parse(resolved)) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 10U);
}

TEST(ResolvedDefaults, KeysWithADefaultComeBackWhereverTheyStood) {
  const Json whole = Json::parse(load_scenario(kSource / "scenes/teaching_gallbladder.yaml", {}).resolved);
  Json older = whole;
  older["simulation"].erase("gravity");
  older["camera"].erase("aperture");
  older["cameras"]["side"].erase("auto_exposure");
  older["bodies"].begin()->at("wall").erase("density");
  for (Json& clip : older["timeline"]) {
    if (clip.contains("palpate")) clip["palpate"].erase("standoff");
  }
  ASSERT_NE(older, whole);
  EXPECT_EQ(filled(older), whole);
}

TEST(ResolvedDefaults, KeysOfACaseComeBackOnlyInThatCase) {
  EXPECT_EQ(filled({{"camera", {{"kind", "pinhole"}}}})["camera"]["field_of_view"],
            filled(Json::object())["camera"]["field_of_view"]);
  EXPECT_NE(filled({{"camera", {{"kind", "endoscope"}}}})["camera"]["field_of_view"],
            filled(Json::object())["camera"]["field_of_view"]);
  EXPECT_FALSE(filled({{"camera", {{"kind", "of later versions"}}}})["camera"].contains("field_of_view"));
}

TEST(ResolvedDefaults, WhatIsNoScenarioStaysAsItIs) {
  EXPECT_EQ(with_defaults("no JSON"), "no JSON");
  EXPECT_EQ(with_defaults("[1]"), "[1]");
  const Json odd = {{"camera", 3}, {"timeline", {1, "a", {{"unknown", 2}}}}, {"bodies", {{"organ", Json::array()}}}};
  const Json result = filled(odd);
  for (const auto& [key, value] : odd.items()) EXPECT_EQ(result[key], value);
}

}  // namespace
}  // namespace thinwall
