#include "renderer/metric/Tiles.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>

namespace thinwall {
namespace {

constexpr int kMostThreads = 8;

int thread_count(int wanted, std::size_t work) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int threads = wanted > 0 ? wanted : std::min(cores, kMostThreads);
  return static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(threads), work));
}

}  // namespace

std::vector<PixelRegion> tiles_of(ImageSize size, int edge) {
  std::vector<PixelRegion> tiles;
  for (int top = 0; top < size.height; top += edge) {
    for (int left = 0; left < size.width; left += edge) {
      tiles.push_back({left, top, std::min(left + edge, size.width), std::min(top + edge, size.height)});
    }
  }
  return tiles;
}

PixelRegion grown(const PixelRegion& region, int margin, ImageSize size) {
  return {std::max(0, region.left - margin), std::max(0, region.top - margin),
          std::min(size.width, region.right + margin), std::min(size.height, region.bottom + margin)};
}

bool differs_in(const Image& first, const Image& second, const PixelRegion& region) {
  for (int y = region.top; y < region.bottom; ++y) {
    const auto start = (static_cast<std::size_t>(y) * static_cast<std::size_t>(first.size.width) +
                        static_cast<std::size_t>(region.left)) *
                       3;
    const std::size_t count = static_cast<std::size_t>(region.width()) * 3;
    if (std::memcmp(&first.pixels[start], &second.pixels[start], count) != 0) return true;
  }
  return false;
}

void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& work, int threads) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failure_lock;
  const auto take_work = [&] {
    for (std::size_t index = next++; index < count; index = next++) {
      try {
        work(index);
      } catch (...) {
        const std::lock_guard guard(failure_lock);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> helpers;
  for (int i = 1; i < thread_count(threads, count); ++i) helpers.emplace_back(take_work);
  take_work();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace thinwall
