#include "renderer/shape/WoundLayout.hpp"

#include <gtest/gtest.h>

#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

/// Of a sheet that falls towards -y and has been cut along x at 10 mm/s, to `until` (seconds); `whole` millimetres of
/// its 20 are left whole at either end.
WoundLayout layout_of(std::uint32_t whole, double until) {
  SnapshotTopology sheet = *test::slit_sheet(20, 0.001, 0.8, whole).topology;
  const double end = 0.01 - 0.001 * whole;
  for (std::size_t v = 0; v < sheet.cut_times.size(); ++v) {
    if (sheet.cut_times[v] < 0) continue;
    sheet.cut_times[v] = static_cast<float>(until + 100 * (sheet.rest_positions[v][0] - end));
  }
  const std::vector<BorderEdge> borders = border_edges(sheet);
  return lay_out_wounds(sheet, borders, cut_lips(sheet, borders), {0, 0, -1});
}

TEST(WoundLayout, LetsNothingRunFromTheEndsOfACut) {
  const WoundLayout layout = layout_of(2, 5);
  ASSERT_FALSE(layout.fluid_runs.empty());
  ASSERT_FALSE(layout.blood_runs.empty());
  for (const auto* runs : {&layout.fluid_runs, &layout.blood_runs}) {
    for (const FluidRun& run : *runs) {
      for (const std::uint32_t v : run.path.front().corners) {
        const bool is_lip = layout.map.lip[v] == v;
        EXPECT_TRUE(!is_lip || layout.map.from_end[v] >= 0.0015) << layout.map.from_end[v];
      }
      EXPECT_LT(run.born, 5);
    }
  }
}

TEST(WoundLayout, LetsACutThatIsAllEndsRunOnceItGoesOnNoMore) {
  // 4 mm long.
  const WoundLayout layout = layout_of(8, 5);
  ASSERT_FALSE(layout.fluid_runs.empty()) << "what leaks comes out somewhere";
  for (const FluidRun& run : layout.fluid_runs) EXPECT_NEAR(run.born, 5.3, 1e-4);
}

}  // namespace
}  // namespace thinwall
