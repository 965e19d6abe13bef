#include "studio/recorder/GroundTruthSeries.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "renderer/snapshot/SurfaceFields.hpp"
#include "tests/studio/SyntheticRun.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

/// The dented sheet as a frame, with stress in its wall.
Frame frame_at(std::size_t step) {
  Frame frame{.snapshot = SyntheticRun().moment(step).snapshot, .overlay = {}};
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

Frame card_at(std::size_t step) {
  Frame frame = frame_at(step);
  frame.card = Card{.title = "A sheet"};
  return frame;
}

/// Ground truth of some frames, in a folder of its own.
class Series {
 public:
  explicit Series(const std::vector<Frame>& frames) {
    GroundTruthSeries series({.folder = folder_ / "truth", .size = {.width = 48, .height = 32}});
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

}  // namespace
}  // namespace thinwall
