#include <benchmark/benchmark.h>

#include "renderer/image/PngFile.hpp"
#include "renderer/metric/Ladder.hpp"
#include "tests/renderer/metric/MetricImages.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{1920, 1080};

enum Pair { kEqual, kLocal, kWhole };

/// The first picture's partner: the same, with a changed spot, or changed everywhere.
Image partner(const Image& image, int pair) {
  if (pair == kWhole) return tinted(shaded_image(kSize, 1), 1.02, 1, 1);
  Image other = image;
  if (pair == kEqual) return other;
  for (int y = 500; y < 540; ++y) {
    for (int x = 900; x < 960; ++x) other.pixels[static_cast<std::size_t>(3 * (y * kSize.width + x))] ^= 128;
  }
  return other;
}

void climb(benchmark::State& state, const PictureLimits& limits) {
  const Image first = shaded_image(kSize);
  const Image second = partner(first, static_cast<int>(state.range(0)));
  PictureOptions options;
  options.limits = limits;
  for (auto _ : state) benchmark::DoNotOptimize(climb_ladder(first, second, options));
}

void pixels(benchmark::State& state) {
  climb(state, {.largest = 255, .mean = 255});
}
void shifted_pixels(benchmark::State& state) {
  climb(state, {.failing = 1, .tolerance = {.level = 4, .shift = 1}});
}
void structure(benchmark::State& state) {
  climb(state, {.structure = -1});
}
void flip_error(benchmark::State& state) {
  climb(state, {.flip = 1});
}

/// What reading a picture costs beside its comparison.
void read_picture(benchmark::State& state) {
  const std::vector<std::uint8_t> bytes = encode_png(shaded_image(kSize));
  for (auto _ : state) benchmark::DoNotOptimize(decode_png(bytes, "picture"));
}

void set_up(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("pair")->DenseRange(kEqual, kWhole)->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK(pixels)->Apply(set_up);
BENCHMARK(shifted_pixels)->Apply(set_up);
BENCHMARK(structure)->Apply(set_up);
BENCHMARK(flip_error)->Apply(set_up);
BENCHMARK(read_picture)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace thinwall
