#include "renderer/metric/SeparableFilter.hpp"

#include "renderer/metric/Lanes.hpp"

namespace thinwall {
namespace {

using lanes::Lanes;

constexpr int kBlocks = kFilterStep / lanes::kCount;  // whose sums stay in registers along the kernel

THINWALL_FOR_ALL_PROCESSORS
void filter_rows(const FilterPass& pass, const float* weights, int radius, float sign) {
  for (int y = 0; y < pass.rows; ++y) {
    for (int x = 0; x < pass.width; x += kFilterStep) {
      const float* center = pass.from + y * pass.pitch + x;
      Lanes sums[kBlocks];
      for (int block = 0; block < kBlocks; ++block) {
        lanes::load(sums[block], center + block * lanes::kCount);
        sums[block] *= weights[0];
      }
      for (int k = 1; k <= radius; ++k) {
        const float* after = center + k * pass.stride;
        const float* before = center - k * pass.stride;
        for (int block = 0; block < kBlocks; ++block) {
          Lanes plus;
          Lanes minus;
          lanes::load(plus, after + block * lanes::kCount);
          lanes::load(minus, before + block * lanes::kCount);
          sums[block] += weights[k] * (plus + sign * minus);
        }
      }
      for (int block = 0; block < kBlocks; ++block) {
        lanes::store(sums[block], pass.to + static_cast<std::ptrdiff_t>(y) * pass.width + x + block * lanes::kCount);
      }
    }
  }
}

}  // namespace

void filter(const FilterPass& pass, const Kernel& kernel) {
  filter_rows(pass, kernel.weights.data(), kernel.radius(), kernel.odd ? -1.0F : 1.0F);
}

}  // namespace thinwall
