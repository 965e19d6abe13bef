#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {

/// How the program ended and what it said.
struct ProgramEnd {
  int exit_code = -1;  // -1: killed by a signal
  std::string output;
  std::string messages;
};

struct ProgramSetting {
  std::filesystem::path folder;                    // that it runs in
  std::map<std::string, std::string> environment;  // added to ours
  rlim_t largest_file = RLIM_INFINITY;             // bytes
  std::filesystem::path input = {};                // what it reads; ours when empty
};

/// The thinwall program, running.
class RunningProgram {
 public:
  RunningProgram(std::vector<std::string> arguments, const ProgramSetting& setting) {
    arguments.insert(arguments.begin(), THINWALL_PROGRAM);
    process_ = fork();
    if (process_ == 0) start(arguments, setting);
  }

  void send_signal(int signal) const { kill(process_, signal); }

  /// Returns once it has told `words`.
  void wait_for_message(const std::string& words) const {
    while (file_bytes(said_ / "messages").find(words) == std::string::npos) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  ProgramEnd wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            .output = file_bytes(said_ / "output"),
            .messages = file_bytes(said_ / "messages")};
  }

 private:
  [[noreturn]] void start(const std::vector<std::string>& arguments, const ProgramSetting& setting) const {
    const int output = open((said_ / "output").c_str(), O_CREAT | O_WRONLY, 0600);
    const int messages = open((said_ / "messages").c_str(), O_CREAT | O_WRONLY, 0600);
    dup2(output, 1);
    dup2(messages, 2);
    if (!setting.input.empty()) dup2(open(setting.input.c_str(), O_RDONLY), 0);
    if (!setting.folder.empty() && chdir(setting.folder.c_str()) != 0) _exit(99);
    for (const auto& [name, value] : setting.environment) setenv(name.c_str(), value.c_str(), 1);
    const struct rlimit limit = {setting.largest_file, setting.largest_file};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::vector<char*> pointers;
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    execv(pointers[0], pointers.data());
    _exit(98);
  }

  TemporaryFolder said_;
  pid_t process_ = -1;
};

inline ProgramEnd run_thinwall(const std::vector<std::string>& arguments, const ProgramSetting& setting = {}) {
  return RunningProgram(arguments, setting).wait();
}

/// Runs a scenario of a folder that takes long into its folder `out`, and sends it a signal midway: once a buffer full
/// of rows has reached the disk.
inline ProgramEnd run_stopped_midway(const std::filesystem::path& folder, const std::string& scenario, int signal) {
  RunningProgram program({"run", scenario, "--no-render", "--out", "out"}, {.folder = folder, .environment = {}});
  const std::filesystem::path rows = folder / "out" / "forces.unfinished.csv";
  std::error_code none;
  while (!std::filesystem::exists(rows) || std::filesystem::file_size(rows, none) < 10'000) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  program.send_signal(signal);
  return program.wait();
}

/// A scenario that takes little time: the coarsest hemisphere under a probe.
inline std::string small_scenario(const std::string& timeline = "") {
  const std::string palpation =
      "  - palpate: { tool: probe, body: organ, at: [0, 0, 20 mm], direction: [0, 0, -1], depth: \"${depth}\",\n"
      "      speed: 20 mm/s, standoff: 1 mm, caption: Pressing, chapter: Palpation }\n";
  return "thinwall: 1\n"
         "title: A small hemisphere\n"
         "parameters: { depth: 2 mm }\n"
         "bodies:\n"
         "  organ:\n"
         "    surface: { shape: hemisphere, radius: 20 mm, triangles: 64 }\n"
         "    wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 20 kPa } }\n"
         "    fixed: [ { region: { group: base }, axes: xyz } ]\n"
         "tools:\n"
         "  probe: { kind: point }\n"
         "timeline:\n" +
         palpation + timeline +
         "simulation: { analysis: quasi_static, time_step: 10 ms }\n"
         "record: { size: [160, 96], fps: 25, tier: draft }\n";
}

/// A scenario that cuts a filled ball over its top; `incise` is what its clip says besides tool and body.
inline std::string incision_scenario(const std::string& incise =
                                         "path: [[-6 mm, 0, 20 mm], [6 mm, 1 mm, 20 mm]], "
                                         "depth: 3 mm") {
  return "thinwall: 1\n"
         "bodies:\n"
         "  organ:\n"
         "    surface: { shape: sphere, radius: 20 mm, triangles: 320 }\n"
         "    wall: { thickness: 1 mm, material: { law: neo_hookean, shear_modulus: 20 kPa }, toughness: 100 J/m^2 }\n"
         "    contents: { fluid: incompressible, pressure: 500 Pa }\n"
         "    fixed: [ { region: { below: { axis: z, at: -10 mm } } } ]\n"
         "tools:\n"
         "  blade: { kind: scalpel, length: 12 mm, width: 3 mm, thickness: 0.4 mm }\n"
         "timeline:\n"
         "  - incise: { tool: blade, body: organ, speed: 60 mm/s, standoff: 1 mm, " +
         incise +
         " }\n"
         "simulation: { analysis: dynamic, time_step: 10 ms }\n"
         "record: { size: [160, 96], fps: 30, tier: draft }\n";
}

}  // namespace thinwall
