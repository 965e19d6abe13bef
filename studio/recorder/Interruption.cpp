#include "studio/recorder/Interruption.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <mutex>
#include <thread>

namespace thinwall {
namespace {

std::atomic<int> noted_signal = 0;

sigset_t awaited_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

[[noreturn]] void end_by(int signal) {
  std::signal(signal, SIG_DFL);
  const sigset_t signals = awaited_signals();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  for (;;) std::raise(signal);
}

/// `timeout` sends a signal to the program and to its group, and a service manager may do alike: one wish all the same.
constexpr std::chrono::milliseconds kOneWish{200};

void pass_over_repetitions(const sigset_t& signals) {
  const auto end = std::chrono::steady_clock::now() + kOneWish;
  for (;;) {
    const std::chrono::nanoseconds left = end - std::chrono::steady_clock::now();
    if (left.count() <= 0) return;
    const timespec patience{.tv_sec = 0, .tv_nsec = left.count()};
    sigtimedwait(&signals, nullptr, &patience);
  }
}

void await_signals() {
  const sigset_t signals = awaited_signals();
  int signal = 0;
  while (sigwait(&signals, &signal) != 0) continue;
  noted_signal = signal;
  pass_over_repetitions(signals);
  while (sigwait(&signals, &signal) != 0) continue;
  end_by(signal);
}

}  // namespace

Interrupted::Interrupted(int signal)
    : std::runtime_error(signal == SIGINT ? "interrupted" : "terminated"), signal_(signal) {}

Interrupted::Interrupted(const Interrupted& cause, const std::string& consequence)
    : std::runtime_error(cause.what() + ("; " + consequence)), signal_(cause.signal_) {}

void note_interruptions() {
  static std::once_flag once;
  std::call_once(once, [] {
    // No handler: METIS has its own for SIGTERM while it orders a body, and takes the signal for its own error.
    const sigset_t signals = awaited_signals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::thread(await_signals).detach();
  });
  std::signal(SIGXFSZ, SIG_IGN);
}

void throw_if_interrupted() {
  if (const int signal = noted_signal; signal != 0) throw Interrupted(signal);
}

}  // namespace thinwall
