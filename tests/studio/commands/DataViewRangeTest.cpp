#include "studio/commands/DataViewRange.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/camera/View.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/take/TakeWriter.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

/// A take of equal triangles, each as far from its stress-free place as said, metres.
void write_take(const std::filesystem::path& file, const std::vector<float>& displacements) {
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
  TakeWriter writer(file, {.name = "organ", .title = "An organ", .resolved = R"({"thinwall":1})"});
  writer.write(moment);
  writer.finish({.complete = true, .warnings = {}, .state_digest = std::string(32, '0')});
}

/// The ends that a view of displacements takes from such a take, beside those that it has.
DataView range_of(const std::vector<float>& displacements,
                  const DataView& view = {.quantity = DataQuantity::kDisplacement}) {
  const TemporaryFolder folder;
  write_take(folder / "take.h5", displacements);
  LookDefinition look;
  look.data = view;
  complete_data_range({folder / "take.h5"}, look);
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

TEST(DataViewRange, HoldsWhatTheWallsOfAllTakesBear) {
  const TemporaryFolder folder;
  write_take(folder / "one.h5", evenly(100, 0.001F, 0.002F));
  write_take(folder / "two.h5", evenly(100, 0.003F, 0.004F));
  LookDefinition look;
  look.data = DataView{.quantity = DataQuantity::kDisplacement};
  complete_data_range({folder / "one.h5", folder / "two.h5"}, look);
  EXPECT_NEAR(look.data->from.value(), 0.001, 1e-9);
  EXPECT_NEAR(look.data->to.value(), 0.004, 1e-9);
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

TEST(DataViewRange, RefusesAnEndBeyondAllThatTheWallBears) {
  const std::vector<float> values = evenly(100, 0.001F, 0.002F);
  EXPECT_THROW(range_of(values, {.quantity = DataQuantity::kDisplacement, .from = 0.003}), UsageError);
  EXPECT_THROW(range_of(values, {.quantity = DataQuantity::kDisplacement, .to = 0.0005}), UsageError);
  EXPECT_NEAR(range_of(values, {.quantity = DataQuantity::kDisplacement, .from = 0.0015}).to.value(), 0.002, 1e-9);
}

DataView changed(const DataViewChanges& changes, const std::optional<DataView>& view) {
  LookDefinition look;
  look.data = view;
  change_data_view(changes, look);
  return *look.data;
}

void expect_refused(const DataViewChanges& changes, const std::optional<DataView>& view, const std::string& words) {
  try {
    changed(changes, view);
    FAIL() << words;
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(DataViewRange, ACommandLineChangesEachEndAndTheScaleAlone) {
  const DataView view{.quantity = DataQuantity::kThickness, .from = 0.001, .to = 0.002};
  const DataView lower = changed({.from = Quantity{}}, view);
  EXPECT_EQ(lower.from, 0);
  EXPECT_EQ(lower.to, 0.002);
  EXPECT_EQ(lower.scale, DataScale::kLinear);
  EXPECT_EQ(changed({.to = Quantity{0.003, kLength}}, view).to, 0.003);
  const DataView root = changed({.scale = DataScale::kRoot}, view);
  EXPECT_EQ(root.scale, DataScale::kRoot);
  EXPECT_EQ(root.from, 0.001);
  EXPECT_FALSE(changed({.to = Quantity{0.003, kLength}}, DataView{.quantity = DataQuantity::kThickness}).from);
}

TEST(DataViewRange, AChangeWithoutADataViewIsRefusedWithItsCure) {
  const std::string cure = ": the pictures show no quantity in colours; name one with --data";
  expect_refused({.from = Quantity{}}, std::nullopt, "--data-from" + cure);
  expect_refused({.to = Quantity{}}, std::nullopt, "--data-to" + cure);
  expect_refused({.scale = DataScale::kLinear}, std::nullopt, "--data-scale" + cure);
  LookDefinition look;
  EXPECT_NO_THROW(change_data_view({}, look));
}

TEST(DataViewRange, AChangeOfAnotherDimensionOrInTheWrongOrderIsRefused) {
  const DataView view{.quantity = DataQuantity::kThickness, .from = 0.001, .to = 0.002};
  expect_refused({.to = Quantity{1, kPressure}}, view, "--data-to: thickness is a length, this is a pressure");
  expect_refused({.to = Quantity{3, kDimensionless}}, view, "thickness is a length, this is a plain number");
  expect_refused({.from = Quantity{1, kLength}}, DataView{.quantity = DataQuantity::kStrain},
                 "strain is a plain number");
  expect_refused({.from = Quantity{0.002, kLength}}, view,
                 "--data-from: the colours begin at 0.002 m and end at 0.002 m");
  expect_refused({.from = Quantity{3, kLength}, .to = Quantity{2, kLength}}, view, "must be more than the beginning");
}

}  // namespace
}  // namespace thinwall
