#pragma once

#include <chrono>
#include <ctime>

namespace thinwall {

/// How long a stage worked, waiting for others not counted. Both times, because a thread that shares its core needs
/// more wall time than processor time.
struct StageTime {
  double wall = 0;       // seconds
  double processor = 0;  // seconds, of the stage's own thread
};

/// Adds the time of its scope to a stage.
class StageClock {
 public:
  explicit StageClock(StageTime& stage)
      : stage_(stage), wall_(std::chrono::steady_clock::now()), processor_(thread_seconds()) {}
  ~StageClock() {
    stage_.wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
    stage_.processor += thread_seconds() - processor_;
  }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

 private:
  static double thread_seconds() {
    struct timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  StageTime& stage_;
  std::chrono::steady_clock::time_point wall_;
  double processor_;
};

}  // namespace thinwall
