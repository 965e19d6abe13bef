#include "engine/haptics/HandFollower.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace thinwall {
namespace {

/// How long to wait for news of the hand: a tenth of a tick.
constexpr std::chrono::microseconds kNap{100};

}  // namespace

void RefreshFigures::note(double duration) {
  ++solutions;
  longest = std::max(longest, duration);
  total += duration;
}

HandFollower::HandFollower(Work work) : work_(std::move(work)), thread_([this] { follow(); }) {}

void HandFollower::tell(const HandState& hand) {
  hands_.back() = hand;
  hands_.publish();
}

void HandFollower::follow() {
  try {
    while (!ends_.load(std::memory_order_acquire)) {
      if (hands_.take()) {
        work_(hands_.front());
      } else {
        std::this_thread::sleep_for(kNap);
      }
    }
  } catch (...) {
    failure_ = std::current_exception();
    has_failed_.store(true, std::memory_order_release);
  }
}

void HandFollower::stop() {
  ends_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
}

void HandFollower::finish() {
  stop();
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace thinwall
