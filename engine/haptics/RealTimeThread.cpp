#include "engine/haptics/RealTimeThread.hpp"

#include <pthread.h>
#include <sched.h>

#include <cmath>
#include <ctime>

namespace thinwall {
namespace {

/// Above all ordinary threads, below the system's own.
constexpr int kPriority = 60;

}  // namespace

bool ask_for_real_time() {
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

double loop_clock() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void sleep_until(double time) {
  timespec until{};
  until.tv_sec = static_cast<std::time_t>(std::floor(time));
  until.tv_nsec = static_cast<long>(1e9 * (time - std::floor(time)));
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != 0) {
  }
}

}  // namespace thinwall
