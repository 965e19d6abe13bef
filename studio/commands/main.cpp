#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "studio/commands/CompareLine.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/StandardOutput.hpp"
#include "studio/recorder/Messages.hpp"
#include "studio/recorder/Versions.hpp"

namespace {

/// Has what is allocated lie in pages of 2 MB where the system lends such: in those of 4 KB a software driver waits for
/// a twentieth of its time until it is known where its pictures lie. Not for the haptic loop, which would wait where
/// such a page is first touched; its name may stand behind options. The C library reads this when a program starts.
void ask_for_large_pages(std::span<char* const> words) {
  constexpr const char* kVariable = "GLIBC_TUNABLES";
  constexpr const char* kTunable = "glibc.malloc.hugetlb";
  const char* given = std::getenv(kVariable);
  const std::string tunables = given == nullptr ? "" : given;
  const bool is_haptic = std::ranges::any_of(words, [](const char* word) { return std::string(word) == "haptic"; });
  if (is_haptic || tunables.find(kTunable) != std::string::npos) return;
  setenv(kVariable, (tunables + (tunables.empty() ? "" : ":") + kTunable + "=1").c_str(), 1);
}

/// Goes on as the program with all commands, which stands beside this one. Comes back only when that cannot be.
int become_studio(char** arguments) {
  std::error_code unreadable;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", unreadable);
  const std::filesystem::path studio = here.parent_path() / "thinwall-studio";
  execv(studio.c_str(), arguments);
  thinwall::print_message(stderr, "thinwall: cannot start {}: {}; it is built and installed together with thinwall\n",
                          studio.string(), std::strerror(errno));
  return thinwall::kExitNoPicture;
}

}  // namespace

// Loading the libraries of simulation, graphics and take files takes longer than comparing two pictures, so this
// program compares and says its version by itself and leaves all else to the one that loads them.
int main(int count, char** arguments) {
  if (count == 2 && std::string(arguments[1]) == "--version") {
    return thinwall::exit_code_of([] {
      thinwall::say_result(thinwall::version_text() + "\n");
      return thinwall::kExitGood;
    });
  }
  if (count > 1 && std::string(arguments[1]) == thinwall::kCompareCommand) {
    return thinwall::run_compare_line(std::vector<std::string>(arguments + 1, arguments + count));
  }
  ask_for_large_pages(std::span(arguments, static_cast<std::size_t>(count)));
  return become_studio(arguments);
}
