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

/// From now on a thread of its own waits for SIGINT and SIGTERM and notes them for `throw_if_interrupted`; a second
/// one, a fifth of a second later or more, ends the program at once. Both are blocked in the calling thread and in
/// those that it starts from then on, so to be called before there are others. A limit on file sizes (SIGXFSZ) no
/// longer kills the program: the write is refused, as on a full disk.
void note_interruptions();

/// Throws Interrupted when a signal was noted. To be called between steps and frames.
void throw_if_interrupted();

}  // namespace thinwall
