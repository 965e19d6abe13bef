#include "renderer/video/Program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <thread>

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

std::string words_of(int code) {
  return std::generic_category().message(code);
}

/// What the child gets: default signals, an own group, and our three descriptors as its standard ones.
class SpawnSettings {
 public:
  SpawnSettings(int input, int output, int errors) {
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_init(&actions_);
    sigset_t none;
    sigset_t all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  int spawn(pid_t& process, const std::vector<std::string>& arguments) const {
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    return posix_spawnp(&process, pointers.front(), &actions_, &attributes_, pointers.data(), environ);
  }

 private:
  posix_spawnattr_t attributes_;
  posix_spawn_file_actions_t actions_;
};

std::string text_in(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t count = pread(descriptor, buffer.data(), buffer.size(), static_cast<off_t>(text.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

int exit_code_of(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// The exit code of the ended process, waiting for it.
int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return exit_code_of(status);
}

/// The same without waiting; nothing while it runs.
std::optional<int> look_for_end(pid_t process) {
  int status = 0;
  return waitpid(process, &status, WNOHANG) == process ? std::optional(exit_code_of(status)) : std::nullopt;
}

}  // namespace

// A socket instead of a pipe, because a send to a closed socket can be told not to raise SIGPIPE. What the program says
// goes into files in memory: a pipe that nobody empties would stop it.
Program::Program(const std::vector<std::string>& arguments, ProgramOutput output)
    : streamed_(output == ProgramOutput::kStreamed) {
  std::array<int, 2> ends{-1, -1};
  int code = socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0 ? 0 : errno;
  input_ = ends[0];
  std::array<int, 2> stream{-1, -1};
  if (streamed_ && code == 0 && pipe2(stream.data(), O_CLOEXEC) != 0) code = errno;
  output_ = streamed_ ? stream[0] : memfd_create("output", MFD_CLOEXEC);
  errors_ = memfd_create("errors", MFD_CLOEXEC);
  if (code == 0 && (output_ < 0 || errors_ < 0)) code = errno;
  if (code == 0) {
    code = SpawnSettings(ends[1], streamed_ ? stream[1] : output_, errors_).spawn(process_, arguments);
    close(ends[1]);
  }
  // The stream ends when the program does, so no end of it may stay open here.
  if (stream[1] >= 0) close(stream[1]);
  if (code == 0) return;
  process_ = -1;
  end_input();
  if (output_ >= 0) close(output_);
  if (errors_ >= 0) close(errors_);
  throw PictureFailure("cannot start the program " + arguments.front() + ": " + words_of(code) +
                       (code == ENOENT ? "; install it (on Debian: apt-get install ffmpeg)" : ""));
}

Program::~Program() {
  end_input();
  if (streamed_) end_output();
  if (process_ > 0) {
    kill(process_, SIGKILL);
    wait_for(process_);
  }
  end_output();
  close(errors_);
}

void Program::end_output() {
  if (output_ >= 0) close(output_);
  output_ = -1;
}

void Program::end_input() {
  if (input_ >= 0) close(input_);
  input_ = -1;
}

bool Program::send(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

std::size_t Program::receive(std::span<std::uint8_t> bytes) {
  std::size_t received = 0;
  while (received < bytes.size()) {
    const ssize_t count = read(output_, bytes.data() + received, bytes.size() - received);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    received += static_cast<std::size_t>(count);
  }
  return received;
}

ProgramResult Program::finish() {
  end_input();
  if (streamed_) end_output();
  return result(wait_for(process_));
}

std::optional<ProgramResult> Program::finish_within(std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds kBetweenLooks{10};
  end_input();
  if (streamed_) end_output();
  const auto begin = std::chrono::steady_clock::now();
  for (;;) {
    if (const std::optional<int> exit_code = look_for_end(process_)) return result(*exit_code);
    if (std::chrono::steady_clock::now() - begin >= patience) return std::nullopt;
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

void Program::terminate() {
  if (process_ > 0) kill(process_, SIGTERM);
}

ProgramResult Program::result(int exit_code) {
  process_ = -1;
  return {.exit_code = exit_code, .output = streamed_ ? "" : text_in(output_), .errors = text_in(errors_)};
}

ProgramResult run_program(const std::vector<std::string>& arguments) {
  return Program(arguments).finish();
}

}  // namespace thinwall
