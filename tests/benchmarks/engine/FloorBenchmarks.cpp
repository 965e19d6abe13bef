// What the machine itself can do with one thread: the floors that the other benchmarks are held against.

#include <benchmark/benchmark.h>

#include <vector>

extern "C" void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*, const double*,
                       const int*, const double*, const int*, const double*, double*, const int*);

namespace {

/// a = b + s c over arrays far larger than the caches (the triad of the STREAM benchmark): bytes read and written.
void MemoryBandwidth(benchmark::State& state) {
  const std::size_t size = 8'000'000;
  std::vector<double> a(size), b(size, 1), c(size, 2);
  for (auto _ : state) {
    for (std::size_t k = 0; k < size; ++k) a[k] = b[k] + 3 * c[k];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.counters["bytes"] = 3.0 * 8 * static_cast<double>(size);
}
BENCHMARK(MemoryBandwidth)->Unit(benchmark::kMillisecond);

/// A product of dense matrices, the fastest that the linear algebra in use does.
void PeakOperations(benchmark::State& state) {
  const int n = 768;
  const double one = 1, zero = 0;
  const std::vector<double> a(n * n, 0.5), b(n * n, 0.25);
  std::vector<double> c(n * n);
  for (auto _ : state) {
    dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, c.data(), &n);
    benchmark::DoNotOptimize(c.data());
  }
  state.counters["operations"] = 2.0 * n * n * n;
}
BENCHMARK(PeakOperations)->Unit(benchmark::kMillisecond);

}  // namespace
