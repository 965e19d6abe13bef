#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/look/OrganLooks.hpp"
#include "renderer/picture/Renderer.hpp"
#include "tests/renderer/shape/CutSheets.hpp"

namespace thinwall {
namespace {

/// An organ of as many triangles, 8 times a square, that fills the middle of the picture, with a probe on it.
Snapshot organ_and_probe(int triangles) {
  Snapshot snapshot;
  const int parts = static_cast<int>(std::lround(std::sqrt(triangles / 8.0)));
  snapshot.surfaces.push_back(test::divided_sphere("organ", {0, 0, 0.03}, 0.03, parts));
  SnapshotTool probe;
  probe.kind = SnapshotToolKind::kSphere;
  probe.radius = 0.004;
  probe.tip = {0, 0, 0.06};
  snapshot.tools.push_back(probe);
  return snapshot;
}

ViewDefinition seen_through(bool endoscope) {
  ViewDefinition view;
  if (!endoscope) return view;
  view.camera.kind = CameraKind::kEndoscope;
  view.camera.field_of_view = 1;
  view.lights.endoscope = 1;
  return view;
}

void draw(benchmark::State& state, const Snapshot& snapshot, const ViewDefinition& view, Tier tier) {
  Renderer renderer(DeviceChoice{}, {1280, 720}, tier);
  benchmark::DoNotOptimize(renderer.draw(snapshot, view));  // the first picture compiles the shaders
  for (auto _ : state) benchmark::DoNotOptimize(renderer.draw(snapshot, view));
}

/// Beside the whole, each pass as a counter: milliseconds of all threads, the least of several pictures, since
/// another's load on the machine only ever adds to them.
void tell_passes(benchmark::State& state, const Snapshot& snapshot, const ViewDefinition& view, Tier tier) {
  constexpr int kPictures = 12;
  Renderer renderer(DeviceChoice{}, {1280, 720}, tier);
  for (int k = 0; k < kPictures + 1; ++k) {
    std::vector<PassTime> times;
    renderer.draw_timed(snapshot, view, times);
    // The first picture compiles the shaders.
    for (const PassTime& time : times) {
      const double milliseconds = 1e3 * time.processor_seconds;
      double& least = state.counters.try_emplace(time.pass, milliseconds).first->second.value;
      if (k > 0) least = std::min(least, milliseconds);
    }
  }
}

/// Triangles, tier, whether an endoscope sees it.
void organ(benchmark::State& state) {
  const Snapshot snapshot = organ_and_probe(static_cast<int>(state.range(0)));
  const ViewDefinition view = seen_through(state.range(2) != 0);
  draw(state, snapshot, view, static_cast<Tier>(state.range(1)));
  tell_passes(state, snapshot, view, static_cast<Tier>(state.range(1)));
}
BENCHMARK(organ)
    ->ArgNames({"triangles", "tier", "endoscope"})
    ->ArgsProduct({{5000, 20000}, {0, 1, 2}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

/// Skin of 60 mm with a fresh cut, on a drape.
void sheet(benchmark::State& state) {
  Snapshot snapshot;
  snapshot.surfaces = {test::slit_sheet(32, 0.0019, 0)};
  snapshot.time = 1;
  ViewDefinition view;
  view.camera = {.position = Double3{0.038, -0.062, 0.060}, .target = Double3{0.002, 0, -0.002}};
  view.look.bodies["organ"] = *find_organ_look("skin");
  draw(state, snapshot, view, static_cast<Tier>(state.range(0)));
  tell_passes(state, snapshot, view, static_cast<Tier>(state.range(0)));
}
BENCHMARK(sheet)
    ->ArgName("tier")
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

/// What a picture without anything in it costs: clearing, floor, read-back.
void nothing(benchmark::State& state) {
  draw(state, {}, {}, static_cast<Tier>(state.range(0)));
}
BENCHMARK(nothing)
    ->ArgName("tier")
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace thinwall
