#include "studio/organs/MeshFile.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <optional>

#include "studio/organs/AssimpReader.hpp"

namespace thinwall {
namespace {

/// The child waits for nothing but the disk; this only ends one that hangs there.
constexpr int kWaitSeconds = 300;

constexpr char kGood = 'g';
constexpr char kRefused = 'r';

#ifdef __SANITIZE_ADDRESS__
constexpr bool kMemoryCanBeLimited = false;  // the address sanitizer itself maps terabytes
#else
constexpr bool kMemoryCanBeLimited = true;
#endif

template <typename Value>
void append(std::string& bytes, const Value* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
}

void append_count(std::string& bytes, std::size_t count) {
  const std::uint64_t value = count;
  append(bytes, &value, 1);
}

std::string packed(const RawMesh& mesh) {
  std::string bytes(1, kGood);
  append_count(bytes, mesh.vertices.size());
  for (const Eigen::Vector3d& v : mesh.vertices) append(bytes, v.data(), 3);
  append_count(bytes, mesh.triangles.size());
  for (const Eigen::Vector3i& t : mesh.triangles) append(bytes, t.data(), 3);
  append(bytes, mesh.parts.data(), mesh.parts.size());
  append_count(bytes, mesh.part_names.size());
  for (const std::vector<std::string>& names : mesh.part_names) {
    append_count(bytes, names.size());
    for (const std::string& name : names) {
      append_count(bytes, name.size());
      bytes += name;
    }
  }
  return bytes;
}

/// Takes apart what `packed` made. The bytes come from a child that may have lost its mind: every count is checked.
class Unpacker {
 public:
  explicit Unpacker(const std::string& bytes) : bytes_(bytes) {}

  RawMesh mesh() {
    RawMesh mesh;
    mesh.vertices.resize(count(3 * sizeof(double)));
    for (Eigen::Vector3d& v : mesh.vertices) take(v.data(), 3 * sizeof(double));
    mesh.triangles.resize(count(3 * sizeof(int)));
    for (Eigen::Vector3i& t : mesh.triangles) take(t.data(), 3 * sizeof(int));
    mesh.parts.resize(mesh.triangles.size());
    take(mesh.parts.data(), mesh.parts.size() * sizeof(int));
    mesh.part_names.resize(count(sizeof(std::uint64_t)));
    for (std::vector<std::string>& names : mesh.part_names) {
      names.resize(count(sizeof(std::uint64_t)));
      for (std::string& name : names) {
        name.resize(count(1));
        take(name.data(), name.size());
      }
    }
    check(mesh);
    return mesh;
  }

 private:
  void take(void* target, std::size_t size) {
    if (size > bytes_.size() - place_) throw MeshFileError("the reader of its format broke down on it");
    std::memcpy(target, bytes_.data() + place_, size);
    place_ += size;
  }
  std::size_t count(std::size_t size_of_one) {
    std::uint64_t value = 0;
    take(&value, sizeof(value));
    if (value > (bytes_.size() - place_) / size_of_one)
      throw MeshFileError("the reader of its format broke down on it");
    return value;
  }
  static void check(const RawMesh& mesh) {
    const int vertices = static_cast<int>(mesh.vertices.size());
    const int parts = static_cast<int>(mesh.part_names.size());
    const bool corners_good = std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Eigen::Vector3i& t) {
      return t.minCoeff() >= 0 && t.maxCoeff() < vertices;
    });
    const bool parts_good =
        std::all_of(mesh.parts.begin(), mesh.parts.end(), [&](int part) { return part >= 0 && part < parts; });
    if (!corners_good || !parts_good) throw MeshFileError("the reader of its format broke down on it");
  }

  const std::string& bytes_;
  std::size_t place_ = 1;
};

std::uintmax_t mapped_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::uintmax_t pages = 0;
  statm >> pages;
  return pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
}

void set_limit(decltype(RLIMIT_CPU) what, std::uintmax_t value) {
  const rlimit limit{value, value};
  setrlimit(what, &limit);
}

void confine(const MeshFileLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, SIG_DFL);
  // An interrupt of the whole group is the parent's to answer; it takes the child with it.
  std::signal(SIGINT, SIG_IGN);
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_CPU, static_cast<std::uintmax_t>(limits.processor_seconds));
  if (kMemoryCanBeLimited) set_limit(RLIMIT_AS, mapped_bytes() + limits.memory_bytes);
  // A failing allocator writes its last words to the terminal.
  const int nowhere = open("/dev/null", O_RDWR);
  if (nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
}

[[noreturn]] void read_in_child(const std::filesystem::path& file, const MeshFileLimits& limits, int pipe_end) {
  confine(limits);
  std::string answer;
  try {
    answer = packed(read_with_assimp(file, limits));
  } catch (const MeshFileError& error) {
    answer = kRefused + std::string(error.what());
  } catch (const std::bad_alloc&) {
    answer = kRefused + fmt::format("reading it takes more than {} MiB of memory", limits.memory_bytes >> 20);
  } catch (...) {
    answer = kRefused + std::string("the reader of its format broke down on it");
  }
  for (std::size_t sent = 0; sent < answer.size();) {
    const ssize_t part = write(pipe_end, answer.data() + sent, answer.size() - sent);
    if (part < 0 && errno != EINTR) break;
    if (part > 0) sent += static_cast<std::size_t>(part);
  }
  // Without destructors and exit handlers: they belong to the parent.
  _exit(0);
}

/// All that the child sends; nothing when it takes longer than the wait.
std::optional<std::string> receive(int pipe_end) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(kWaitSeconds);
  std::string bytes;
  std::array<char, 1 << 16> buffer{};
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    if (left.count() <= 0) return std::nullopt;
    pollfd waiting{pipe_end, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(left.count())) <= 0) continue;
    const ssize_t got = read(pipe_end, buffer.data(), buffer.size());
    if (got == 0) return bytes;
    if (got > 0) bytes.append(buffer.data(), static_cast<std::size_t>(got));
    if (got < 0 && errno != EINTR) return bytes;
  }
}

std::string end_of(int status, const MeshFileLimits& limits) {
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) {
    return fmt::format("reading it takes more than {} s; it is malformed or far too large", limits.processor_seconds);
  }
  return "the reader of its format crashes on it: it is malformed; save it anew from a modelling program";
}

std::string read_isolated(const std::filesystem::path& file, const MeshFileLimits& limits) {
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) throw MeshFileError(fmt::format("no pipe: {}", std::strerror(errno)));
  const pid_t child = fork();
  if (child == 0) {
    close(pipe_ends[0]);
    read_in_child(file, limits, pipe_ends[1]);
  }
  close(pipe_ends[1]);
  if (child < 0) {
    close(pipe_ends[0]);
    throw MeshFileError(fmt::format("no process to read it in: {}", std::strerror(errno)));
  }
  const std::optional<std::string> bytes = receive(pipe_ends[0]);
  close(pipe_ends[0]);
  if (!bytes) kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!bytes || bytes->empty() || !WIFEXITED(status)) throw MeshFileError(end_of(status, limits));
  return *bytes;
}

void check_file(const std::filesystem::path& file, const MeshFileLimits& limits) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(file, failure);
  if (!std::filesystem::exists(status)) throw MeshFileError("there is no such file");
  if (!std::filesystem::is_regular_file(status)) throw MeshFileError("it is not a file");
  if (!std::ifstream(file)) throw MeshFileError("it may not be read: permission denied");
  const std::uintmax_t size = std::filesystem::file_size(file);
  if (size == 0) throw MeshFileError("the file is empty");
  if (size > limits.file_bytes) {
    throw MeshFileError(
        fmt::format("the file is larger than the {} bytes that are read; reduce the mesh first", limits.file_bytes));
  }
}

}  // namespace

RawMesh read_mesh_file(const std::filesystem::path& file, const MeshFileLimits& limits) {
  check_file(file, limits);
  const std::string bytes = read_isolated(file, limits);
  if (bytes.front() == kRefused) throw MeshFileError(bytes.substr(1));
  return Unpacker(bytes).mesh();
}

}  // namespace thinwall
