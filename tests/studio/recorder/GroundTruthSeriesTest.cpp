#include "studio/recorder/GroundTruthSeries.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "renderer/shape/WoundBed.hpp"
#include "renderer/snapshot/SurfaceFields.hpp"
#include "tests/renderer/shape/CutSheets.hpp"
#include "tests/studio/SyntheticRun.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

/// As a frame, with stress in its first wall.
Frame frame_of(Snapshot snapshot) {
  Frame frame{.snapshot = std::move(snapshot), .overlay = {}};
  SnapshotSurface& surface = frame.snapshot.surfaces[0];
  for (const std::string_view name : {kLargestStressField, kSmallestStressField}) {
    surface.fields.push_back({.name = std::string(name),
                              .unit = "Pa",
                              .location = FieldLocation::kTriangle,
                              .values = std::vector<float>(surface.topology->triangles.size(), 1)});
  }
  surface.fields.push_back({.name = std::string(kContactPressureField),
                            .unit = "Pa",
                            .location = FieldLocation::kVertex,
                            .values = std::vector<float>(surface.positions.size(), 1)});
  return frame;
}

/// Of the dented sheet.
Frame frame_at(std::size_t step) {
  return frame_of(SyntheticRun().moment(step).snapshot);
}

Frame card_at(std::size_t step) {
  Frame frame = frame_at(step);
  frame.card = Card{.title = "A sheet"};
  return frame;
}

/// Ground truth of some frames, in a folder of its own.
class Series {
 public:
  explicit Series(const std::vector<Frame>& frames, const LookDefinition& look = {}) {
    GroundTruthSeries series({.folder = folder_ / "truth", .size = {.width = 48, .height = 32}, .look = look});
    for (const Frame& frame : frames) series.add(frame);
    series.finish();
  }

  std::string layer(const std::string& name, int frame) const {
    const std::string number = std::to_string(frame);
    const std::filesystem::path folder = folder_ / "truth" / name;
    for (const char* ending : {".png", ".exr"}) {
      const auto file = folder / ("frame_" + std::string(6 - number.size(), '0') + number + ending);
      if (std::filesystem::exists(file)) return file_bytes(file);
    }
    return {};
  }
  nlohmann::json description() const {
    return nlohmann::json::parse(file_bytes(folder_ / "truth" / "ground_truth.json"));
  }

 private:
  TemporaryFolder folder_;
};

TEST(GroundTruthSeries, AFrameBesideACardHasNoFlowThereAsTheFirstAndTheLastOneHaveNone) {
  const Series alone({frame_at(5), frame_at(6)});
  const Series between_cards({card_at(5), frame_at(5), frame_at(6), card_at(6)});
  for (const std::string layer : {"flow", "flow_kitti", "state"}) {
    ASSERT_FALSE(alone.layer("backward_" + layer, 0).empty());
    EXPECT_EQ(between_cards.layer("backward_" + layer, 1), alone.layer("backward_" + layer, 0)) << layer;
    EXPECT_EQ(between_cards.layer("forward_" + layer, 1), alone.layer("forward_" + layer, 0)) << layer;
    EXPECT_EQ(between_cards.layer("backward_" + layer, 2), alone.layer("backward_" + layer, 1)) << layer;
    EXPECT_EQ(between_cards.layer("forward_" + layer, 2), alone.layer("forward_" + layer, 1)) << layer;
    EXPECT_NE(alone.layer("backward_" + layer, 0), alone.layer("backward_" + layer, 1)) << layer;
  }
}

TEST(GroundTruthSeries, SaysWhatPicturesShowAndItHasNothingOf) {
  EXPECT_EQ(Series({frame_at(0)}).description()["left_out"],
            nlohmann::json({"fluid", "run-off", "drops", "blood", "bed", "right half", "inset", "card"}));
}

TEST(GroundTruthSeriesTest, APieceThatWasCutFreeLiesWherePicturesShowIt) {
  Snapshot fallen;
  SnapshotSurface& sheet = fallen.surfaces.emplace_back(test::patched_sheet(40, 0.001, 8));
  for (std::size_t v = sheet.positions.size() - 81; v < sheet.positions.size(); ++v) sheet.positions[v][2] = -0.2F;
  LookDefinition look;
  look.bodies["organ"].bed = 0.004;
  const Snapshot laid = laid_on_beds(fallen, look);
  ASSERT_GT(laid.surfaces[0].positions.back()[2], -0.02F);
  const Series told({frame_of(fallen)}, look), shown({frame_of(laid)}, look), without_bed({frame_of(fallen)});
  EXPECT_EQ(told.layer("depth", 0), shown.layer("depth", 0));
  EXPECT_EQ(told.layer("instances", 0), shown.layer("instances", 0));
  EXPECT_NE(told.layer("depth", 0), without_bed.layer("depth", 0));
}

}  // namespace
}  // namespace thinwall
