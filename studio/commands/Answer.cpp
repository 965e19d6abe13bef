#include "studio/commands/Answer.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>

#include "studio/recorder/Interruption.hpp"

namespace thinwall {
namespace {

constexpr int kBetweenLooksForSignals = 50;  // milliseconds

}  // namespace

// Not by std::cin, which goes on to wait after a signal, and whose buffer hides from poll what it has read.
std::optional<std::string> read_answer() {
  std::string line;
  for (;;) {
    throw_if_interrupted();
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    const int ready = ::poll(&input, 1, kBetweenLooksForSignals);
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    char letter = 0;
    const ssize_t count = ::read(STDIN_FILENO, &letter, 1);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return line.empty() ? std::nullopt : std::optional(line);
    if (letter == '\n') return line;
    line += letter;
  }
}

}  // namespace thinwall
