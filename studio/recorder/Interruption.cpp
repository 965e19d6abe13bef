#include "studio/recorder/Interruption.hpp"

#include <atomic>
#include <csignal>
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

void await_signals() {
  for (const sigset_t signals = awaited_signals();;) {
    int signal = 0;
    if (sigwait(&signals, &signal) != 0) continue;
    if (noted_signal.exchange(signal) != 0) end_by(signal);
  }
}

}  // namespace

Interrupted::Interrupted(int signal)
    : std::runtime_error(signal == SIGINT ? "interrupted" : "terminated"), signal_(signal) {}

Interrupted::Interrupted(const Interrupted& cause, const std::string& consequence)
    : std::runtime_error(cause.what() + ("; " + consequence)), signal_(cause.signal_) {}

void note_interruptions() {
  static std::once_flag once;
  std::call_once(once, [] {
    // No handler: METIS has one of its own for SIGTERM while it orders a body, and takes the signal for an error of
    // its.
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
