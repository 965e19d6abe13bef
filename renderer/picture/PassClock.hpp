#pragma once

#include <epoxy/gl.h>

#include <chrono>
#include <ctime>
#include <vector>

#include "renderer/picture/Renderer.hpp"

namespace thinwall {

/// Says when passes end; waits for them only when somebody wants to know.
class PassClock {
 public:
  explicit PassClock(std::vector<PassTime>* times) : times_(times) {}
  bool is_running() const { return times_ != nullptr; }
  void ends(const char* pass) {
    if (times_ == nullptr) return;
    glFinish();
    const Wall::time_point wall = Wall::now();
    const std::clock_t processor = std::clock();
    times_->push_back({.pass = pass,
                       .wall_seconds = std::chrono::duration<double>(wall - wall_).count(),
                       .processor_seconds = static_cast<double>(processor - processor_) / CLOCKS_PER_SEC});
    wall_ = wall;
    processor_ = processor;
  }

 private:
  using Wall = std::chrono::steady_clock;
  std::vector<PassTime>* times_;
  Wall::time_point wall_ = Wall::now();
  std::clock_t processor_ = std::clock();
};

}  // namespace thinwall
