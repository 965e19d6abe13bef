#include "studio/recorder/SurfaceSeries.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/studio/SyntheticRun.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

/// The numbers of an array of a VTK file by its name, read as the format says: offset into the appended data, size in
/// bytes, numbers.
template <typename Number>
std::vector<Number> array_of(const std::string& file, const std::string& name) {
  const std::string key = "offset=\"";
  const std::size_t element = file.find("Name=\"" + name + "\"");
  if (element == std::string::npos) return {};
  const std::size_t offset = std::stoul(file.substr(file.find(key, element) + key.size()));
  const std::string mark = "<AppendedData encoding=\"raw\">_";
  const std::size_t place = file.find(mark) + mark.size() + offset;
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, file.data() + place, sizeof bytes);
  std::vector<Number> numbers(bytes / sizeof(Number));
  std::memcpy(numbers.data(), file.data() + place + sizeof bytes, bytes);
  return numbers;
}

TEST(SurfaceSeriesTest, AFileHoldsTheSurface) {
  const SnapshotSurface surface = SyntheticRun().moment(12).snapshot.surfaces[0];
  const std::string file = vtk_poly_data(surface);
  EXPECT_NE(file.find("NumberOfPoints=\"81\""), std::string::npos);
  EXPECT_NE(file.find("NumberOfPolys=\"128\""), std::string::npos);
  const std::vector<float> points = array_of<float>(file, "Points");
  ASSERT_EQ(points.size(), 3 * surface.positions.size());
  EXPECT_EQ(points[3 * 40 + 2], surface.positions[40][2]);
  const auto connectivity = array_of<std::int64_t>(file, "connectivity");
  ASSERT_EQ(connectivity.size(), 3 * 128U);
  EXPECT_EQ(connectivity[3 * 5 + 1], surface.topology->triangles[5][1]);
  const auto offsets = array_of<std::int64_t>(file, "offsets");
  EXPECT_EQ(offsets.front(), 3);
  EXPECT_EQ(offsets.back(), 3 * 128);
  EXPECT_EQ(array_of<float>(file, "stretch"), surface.fields[0].values);
  EXPECT_EQ(array_of<float>(file, "thickness_at_rest (m)"), surface.topology->thickness);
}

TEST(SurfaceSeriesTest, TheCollectionNamesAFileForEachTime) {
  const TemporaryFolder folder;
  const SyntheticRun run;
  SurfaceSeries series(folder.path());
  for (const std::size_t step : {0U, 10U, 20U}) series.write(run.moment(step).snapshot);
  EXPECT_FALSE(std::filesystem::exists(folder / "surfaces"));
  series.finish();
  const std::string collection = file_bytes(folder / "surfaces" / "surfaces.pvd");
  EXPECT_NE(collection.find(R"(<DataSet timestep="0.05" part="0" file="body_0_000001.vtp"/>)"), std::string::npos)
      << collection;
  EXPECT_TRUE(std::filesystem::exists(folder / "surfaces" / "body_0_000002.vtp"));
}

}  // namespace
}  // namespace thinwall
