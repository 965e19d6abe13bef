#include "studio/commands/DataViewRange.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "renderer/picture/View.hpp"
#include "studio/take/TakeReader.hpp"
#include "studio/take/TakeWriter.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

/// The ends that a view of displacements takes from equal triangles, each as far from its stress-free place as said,
/// metres.
DataView range_of(const std::vector<float>& displacements) {
  auto topology = std::make_shared<SnapshotTopology>();
  SnapshotSurface surface{.body = "organ", .topology = topology, .positions = {}, .fields = {}};
  for (const float displacement : displacements) {
    const auto first = static_cast<std::uint32_t>(topology->rest_positions.size());
    topology->triangles.push_back({first, first + 1, first + 2});
    for (const Float3& corner : {Float3{0, 0, 0}, Float3{0.01F, 0, 0}, Float3{0, 0.01F, 0}}) {
      topology->rest_positions.push_back(corner);
      surface.positions.push_back({corner[0], corner[1], displacement});
    }
  }
  topology->thickness.assign(topology->triangles.size(), 0.001F);
  Moment moment;
  moment.snapshot.surfaces = {surface};
  moment.record.bodies = {{.body = "organ"}};
  const TemporaryFolder folder;
  TakeWriter writer(folder / "take.h5", {.name = "organ", .title = "An organ", .resolved = R"({"thinwall":1})"});
  writer.write(moment);
  writer.finish({.complete = true, .warnings = {}, .state_digest = std::string(32, '0')});
  LookDefinition look;
  look.data = DataView{.quantity = DataQuantity::kDisplacement};
  complete_data_range(TakeReader(folder / "take.h5"), folder / "take.h5", look);
  return *look.data;
}

std::vector<float> evenly(std::size_t count, float from, float to) {
  std::vector<float> values;
  for (std::size_t k = 0; k < count; ++k) {
    values.push_back(from + (to - from) * static_cast<float>(k) / static_cast<float>(count - 1));
  }
  return values;
}

TEST(DataViewRange, HoldsAllThatAnEvenWallBears) {
  const DataView view = range_of(evenly(100, 0.001F, 0.002F));
  EXPECT_NEAR(view.from.value(), 0.001, 1e-9);
  EXPECT_NEAR(view.to.value(), 0.002, 1e-9);
}

TEST(DataViewRange, LeavesOutTheLittleThatBearsManyTimesAsMuch) {
  std::vector<float> values = evenly(97, 0.001F, 0.002F);
  values.insert(values.end(), 3, 0.1F);
  const DataView view = range_of(values);
  // Tukey's fence lies at 2.5 mm, which is rounded outwards.
  EXPECT_NEAR(view.to.value(), 0.003, 1e-9);
  EXPECT_TRUE(view.goes_on_above);
}

TEST(DataViewRange, LeavesOutNoMoreThanATwentiethOfTheWall) {
  std::vector<float> values = evenly(90, 0.001F, 0.002F);
  values.insert(values.end(), 10, 0.1F);
  EXPECT_GE(range_of(values).to.value(), 0.1 - 1e-6);
}

TEST(DataViewRange, DoesNotCountWhatIsHeldAtItsStressFreePlace) {
  std::vector<float> values = evenly(50, 0.001F, 0.002F);
  values.insert(values.end(), 50, 0);
  const DataView view = range_of(values);
  EXPECT_NEAR(view.from.value(), 0.001, 1e-9);
  EXPECT_TRUE(view.goes_on_below);
}

}  // namespace
}  // namespace thinwall
