#include "studio/recorder/Manifest.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

nlohmann::json manifest_of(const std::filesystem::path& folder, const ViewDefinition& view) {
  const RecordingPlan plan{.folder = folder,
                           .description = {.name = "small", .title = "Small", .resolved = "{}"},
                           .overlays = {},
                           .view = view,
                           .size = {.width = 160, .height = 96},
                           .pictures = false};
  return nlohmann::json::parse(manifest({.command = "run", .source = {}, .device = {}, .overrides = {}}, plan, {}));
}

TEST(Manifest, TellsTheSeedOfTheNoiseOfCameras) {
  const TemporaryFolder folder;
  ViewDefinition view;
  view.camera.seed = 7;
  view.cameras["side"].seed = 8;
  EXPECT_TRUE(manifest_of(folder.path(), view)["seed"].is_null()) << "nothing is drawn by it without noise";
  view.camera.noise = 1.5;
  EXPECT_EQ(manifest_of(folder.path(), view)["seed"], 7);
  view.cameras["side"].noise = 2;
  EXPECT_EQ(manifest_of(folder.path(), view)["seed"], nlohmann::json({{"main", 7}, {"side", 8}}));
  view.cameras["side"].seed = 7;
  EXPECT_EQ(manifest_of(folder.path(), view)["seed"], 7);
}

TEST(Manifest, ListsTheSecondTakeWithTheFiles) {
  const TemporaryFolder folder;
  write_bytes(folder / "forces.csv", "");
  std::filesystem::create_directory(folder / "second_take");
  EXPECT_EQ(manifest_of(folder.path(), {})["files"], nlohmann::json({"forces.csv", "second_take"}));
}

}  // namespace
}  // namespace thinwall
