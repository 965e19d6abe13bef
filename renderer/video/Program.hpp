#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace thinwall {

/// How another program ended and what it said.
struct ProgramResult {
  int exit_code = 0;   // 128 + the signal's number when a signal ended it
  std::string output;  // of its standard output
  std::string errors;  // of its standard error
};

/// What becomes of a program's standard output.
enum class ProgramOutput {
  kKept,      // finish() gives it
  kStreamed,  // receive() gives it while the program runs
};

/// A running program that is fed through its standard input. It has a process group of its own, so an interrupt from
/// the keyboard reaches only us, and we decide what becomes of it. When we die, its input ends.
class Program {
 public:
  /// `arguments` begin with the name, looked up in PATH; no shell takes part. Throws PictureFailure when it cannot be
  /// started.
  explicit Program(const std::vector<std::string>& arguments, ProgramOutput output = ProgramOutput::kKept);
  /// Kills it if it still runs.
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Waits until the program has taken all bytes. False when it takes no more: it has ended or closed its input.
  bool send(std::span<const std::uint8_t> bytes);

  /// Fills `bytes` with streamed output; fewer than asked for only when the output has ended.
  std::size_t receive(std::span<std::uint8_t> bytes);

  /// Ends its input, waits for its end. To be called once. Streamed output that was not received is lost, and a program
  /// that still writes is stopped by that.
  ProgramResult finish();

  /// What `finish` gives, or nothing where the program runs on for so long; its input ends in any case. To be called
  /// again until it gives something.
  std::optional<ProgramResult> finish_within(std::chrono::milliseconds patience);

  /// Asks it to end, by SIGTERM.
  void terminate();

 private:
  ProgramResult result(int exit_code);
  void end_input();
  void end_output();

  int input_ = -1;  // our end of its standard input
  int output_ = -1;
  bool streamed_ = false;
  int errors_ = -1;
  pid_t process_ = -1;
};

/// Runs it to the end without input. Throws PictureFailure when it cannot be started.
ProgramResult run_program(const std::vector<std::string>& arguments);

}  // namespace thinwall
