#pragma once

#include <stdexcept>
#include <string>

namespace thinwall {

/// The user (SIGINT) or the system (SIGTERM) wants the program to end.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(int signal);
  /// `consequence`: what the user has to know, a sentence without its end.
  Interrupted(const Interrupted& cause, const std::string& consequence);
  int exit_code() const { return 128 + signal_; }

 private:
  int signal_;
};

/// From now on SIGINT and SIGTERM are noted for `throw_if_interrupted`; a second one ends the program at once. A limit
/// on file sizes (SIGXFSZ) no longer kills the program: the write is refused, as on a full disk.
void note_interruptions();

/// Throws Interrupted when a signal was noted. To be called between steps and frames.
void throw_if_interrupted();

}  // namespace thinwall
