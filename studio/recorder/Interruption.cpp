#include "studio/recorder/Interruption.hpp"

#include <csignal>

namespace thinwall {
namespace {

volatile std::sig_atomic_t noted_signal = 0;

void note(int signal) {
  noted_signal = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interrupted::Interrupted(int signal)
    : std::runtime_error(signal == SIGINT ? "interrupted" : "terminated"), signal_(signal) {}

Interrupted::Interrupted(const Interrupted& cause, const std::string& consequence)
    : std::runtime_error(cause.what() + ("; " + consequence)), signal_(cause.signal_) {}

void note_interruptions() {
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
  std::signal(SIGXFSZ, SIG_IGN);
}

void throw_if_interrupted() {
  if (noted_signal != 0) throw Interrupted(noted_signal);
}

}  // namespace thinwall
