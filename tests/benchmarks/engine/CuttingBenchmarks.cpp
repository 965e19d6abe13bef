// What the geometry of a cut costs on spheres of 5120 and 20480 triangles: tracing the blade's next step on the wall,
// cutting along it, and a cut right across in one go.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

#include "engine/cutting/CutSurface.hpp"
#include "engine/cutting/SurfaceTrace.hpp"
#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/Shapes.hpp"
#include "tests/engine/cutting/SurfaceWalk.hpp"

namespace thinwall {
namespace {

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(5120)->Arg(20480)->Unit(benchmark::kMillisecond);
}

Eigen::VectorXd positions_of(const SurfaceMesh& mesh) {
  Eigen::VectorXd position(3 * static_cast<Eigen::Index>(mesh.vertices.size()));
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    position.segment<3>(3 * static_cast<Eigen::Index>(v)) = mesh.vertices[v];
  }
  return position;
}

constexpr int kSteps = 24;  // at different places, for some take longer than others

double edge_of(const CutSurface& surface) {
  return 1.52 * std::sqrt(wall_area(surface.mesh()) / static_cast<double>(surface.mesh().triangles.size()));
}

/// A sphere with a cut of four edge lengths, and where the blade goes in its next step of two edge lengths.
struct NextStep {
  CutSurface surface;
  CutPath first;  // of the cut that is there
  CutPath path;   // on the surface with it
  SurfacePoint end;

  NextStep(const CutSurface& sphere, int number) : surface(sphere) {
    const double edge = edge_of(surface);
    const int triangle = static_cast<int>(surface.mesh().triangles.size()) * number / kSteps;
    const SurfacePoint start{.triangle = triangle, .weights = {0.3, 0.3, 0.4}};
    const SurfaceWalk walk = walk_on(surface, start, {1, 0.3 * number, 0.2}, 4 * edge);
    first.points = walk.points;
    const Cut cut = surface.cut(first);
    path = {.from = cut.tip, .points = cut.rest};
    if (path.points.empty()) {
      for (const TriangleSource& source : cut.triangles) {
        const Eigen::Vector3i& corners = surface.mesh().triangles[source.triangle];
        for (int k = 0; k < 3; ++k) {
          if (corners[k] != *cut.tip) continue;
          path.points = {{.triangle = source.triangle, .weights = Eigen::Vector3d::Unit(k)}};
        }
      }
    }
    const SurfaceWalk next = walk_on(surface, path.points.back(), walk.direction, 2 * edge);
    path.points.insert(path.points.end(), next.points.begin() + 1, next.points.end());
    end = next.points.back();
  }
};

std::vector<NextStep> steps_on_sphere(const benchmark::State& state) {
  const CutSurface sphere(make_sphere(1, static_cast<int>(state.range(0))));
  std::vector<NextStep> steps;
  for (int number = 0; number < kSteps; ++number) steps.emplace_back(sphere, number);
  return steps;
}

/// One iteration is one step, here and there in turn.
void cut_steps(benchmark::State& state, double edge_part) {
  const std::vector<NextStep> steps = steps_on_sphere(state);
  const double edge = edge_of(steps[0].surface);
  std::size_t number = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const NextStep& step = steps[number++ % kSteps];
    auto surface = std::make_unique<CutSurface>(step.surface);
    surface->cut(steps[(number + kSteps / 2) % kSteps].first);  // makes room in the arrays of the copy
    state.ResumeTiming();
    benchmark::DoNotOptimize(surface->cut(step.path, {.edge_length = edge_part * edge}).length);
    state.PauseTiming();
    surface.reset();
    state.ResumeTiming();
  }
}

void CutStep(benchmark::State& state) {
  cut_steps(state, 0);
}
BENCHMARK(CutStep)->Apply(sizes);

void RefinedCutStep(benchmark::State& state) {
  cut_steps(state, 0.5);
}
BENCHMARK(RefinedCutStep)->Apply(sizes);

void TraceStep(benchmark::State& state) {
  const NextStep step(CutSurface(make_sphere(1, static_cast<int>(state.range(0)))), 1);
  const Eigen::VectorXd position = positions_of(step.surface.mesh());
  const SurfaceView view{.triangles = step.surface.mesh().triangles, .position = position};
  for (auto _ : state) {
    benchmark::DoNotOptimize(trace(view, step.path.points.front(), step.end).pieces.size());
  }
}
BENCHMARK(TraceStep)->Apply(sizes);

void CopySurface(benchmark::State& state) {
  const NextStep step(CutSurface(make_sphere(1, static_cast<int>(state.range(0)))), 1);
  for (auto _ : state) {
    CutSurface surface = step.surface;
    benchmark::DoNotOptimize(surface.component_count());
  }
}
BENCHMARK(CopySurface)->Apply(sizes);

}  // namespace
}  // namespace thinwall
