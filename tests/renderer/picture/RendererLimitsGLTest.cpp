#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

Snapshot organ_with(SnapshotToolKind kind) {
  Snapshot snapshot;
  snapshot.surfaces.push_back(test::sphere("organ", {0, 0, 0.03}, 0.03, 3));
  SnapshotTool tool;
  tool.kind = kind;
  tool.radius = 0.004;
  tool.length = 0.02;
  tool.tip = {0, 0, 0.06};
  snapshot.tools.push_back(tool);
  return snapshot;
}

/// An organ of that radius on the floor, whose wall is open at the top and has bled and leaked.
Snapshot opened_organ(double radius) {
  SnapshotSurface ball = test::sphere("organ", {0, 0, 0}, static_cast<float>(radius), 4);
  auto topology = std::make_shared<SnapshotTopology>(*ball.topology);
  std::erase_if(topology->triangles, [&](const Triangle& triangle) {
    return ball.positions[triangle[0]][2] > 0.9 * radius && ball.positions[triangle[0]][0] > 0.1 * radius;
  });
  topology->thickness.assign(topology->triangles.size(), static_cast<float>(0.1 * radius));
  topology->cut_times.assign(ball.positions.size(), 0);
  ball.topology = topology;
  Snapshot snapshot;
  snapshot.time = 2;
  snapshot.surfaces = {ball};
  snapshot.scalars = {{"organ.leaked", "m^3", 0.01 * std::pow(radius, 3)}};
  return snapshot;
}

TEST(Renderer, ATinyOrganBleedsAsOneOfAFewMillimetresDoes) {
  ViewDefinition view;
  view.look.bodies["organ"] = TissueLook{};
  Renderer renderer(DeviceChoice{}, {320, 180}, Tier::kRecord);
  const double radius = 0.004;  // is drawn as it is
  EXPECT_EQ(renderer.draw(opened_organ(radius / 16), view).pixels, renderer.draw(opened_organ(radius), view).pixels);
}

TEST(Renderer, APictureDependsOnItsArgumentsAloneNotOnWhatWasDrawnBefore) {
  const Snapshot first = organ_with(SnapshotToolKind::kPoint);
  const Snapshot second = organ_with(SnapshotToolKind::kSphere);
  ViewDefinition other_view;
  other_view.lights.key = 3;
  other_view.look.background = {0.5, 0.5, 0.5};
  for (const Tier tier : {Tier::kDraft, Tier::kRecord, Tier::kFinal}) {
    Renderer renderer(DeviceChoice{}, {160, 90}, tier);
    const Image fresh = renderer.draw(first, {});
    EXPECT_EQ(renderer.draw(first, {}).pixels, fresh.pixels);
    renderer.draw(second, other_view);
    renderer.draw({}, {});
    EXPECT_EQ(renderer.draw(first, {}).pixels, fresh.pixels);
    EXPECT_EQ(Renderer(DeviceChoice{}, {160, 90}, tier).draw(first, {}).pixels, fresh.pixels);
  }
}

TEST(Renderer, MayBeMovedAndUsedFromAnotherThread) {
  Renderer renderer(DeviceChoice{}, {64, 36}, Tier::kRecord);
  const Image here = renderer.draw(organ_with(SnapshotToolKind::kLine), {});
  Renderer moved = std::move(renderer);
  Image there;
  std::thread([&] { there = moved.draw(organ_with(SnapshotToolKind::kLine), {}); }).join();
  EXPECT_EQ(here.pixels, there.pixels);
}

TEST(Renderer, AnySmallSizeIsDrawn) {
  for (const ImageSize size : {ImageSize{1, 1}, {7, 5}, {1, 33}, {641, 3}}) {
    for (const Tier tier : {Tier::kDraft, Tier::kRecord, Tier::kFinal}) {
      const Image image = Renderer(DeviceChoice{}, size, tier).draw(organ_with(SnapshotToolKind::kPoint), {});
      EXPECT_EQ(image.size, size);
      EXPECT_EQ(image.pixels.size(), 3u * size.width * size.height);
    }
  }
}

std::string failure_of(ImageSize size, Tier tier) {
  try {
    Renderer(DeviceChoice{}, size, tier);
  } catch (const PictureFailure& failure) {
    return failure.what();
  }
  return "drawn";
}

TEST(Renderer, ImpossibleSizesAreRefusedWithTheReason) {
  EXPECT_EQ(failure_of({0, 10}, Tier::kRecord),
            "a picture of 0 x 10 pixels cannot be made: width and height start at 1");
  EXPECT_EQ(failure_of({10, -1}, Tier::kFinal),
            "a picture of 10 x -1 pixels cannot be made: width and height start at 1");
  const std::string wide = failure_of({2000000000, 10}, Tier::kFinal);
  EXPECT_EQ(wide.find("a picture of 2000000000 x 10 pixels is beyond this driver's limit of "), 0u) << wide;
  EXPECT_NE(wide.find("choose a smaller size"), std::string::npos) << wide;
  EXPECT_EQ(failure_of({10000, 10000}, Tier::kFinal),
            "a picture of 10000 x 10000 pixels would take 6 GB of frames, 4 GB are allowed; choose a smaller size");
}

/// 64-bit FNV-1a.
std::string digest(const std::vector<std::uint8_t>& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
  return std::to_string(hash);
}

TEST(RendererDigest, DISABLED_IsPrinted) {
  Renderer renderer(DeviceChoice{}, {320, 180}, Tier::kRecord);
  std::printf("digest %s\n", digest(renderer.draw(organ_with(SnapshotToolKind::kSphere), {}).pixels).c_str());
}

/// What another process of this program prints when the software driver is given `threads`.
std::string digest_with_threads(int threads) {
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = "LP_NUM_THREADS=" + std::to_string(threads) + " '" + program +
                              "' --gtest_also_run_disabled_tests --gtest_filter=RendererDigest.DISABLED_IsPrinted";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return {};
  std::string printed;
  for (std::array<char, 256> line; fgets(line.data(), line.size(), pipe);) {
    if (std::string(line.data()).rfind("digest ", 0) == 0) printed = line.data();
  }
  return pclose(pipe) == 0 ? printed : std::string();
}

TEST(RendererDigest, IsTheSameForAnyNumberOfDriverThreads) {
  const std::string alone = digest_with_threads(1);
  EXPECT_FALSE(alone.empty());
  EXPECT_EQ(digest_with_threads(2), alone);
}

}  // namespace
}  // namespace thinwall
