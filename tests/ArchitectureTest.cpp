#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace thinwall {
namespace {

/// A folder of the house, with what its sources may include.
struct Floor {
  const char* folder;
  std::vector<const char*> project;    // beginnings of the project's own paths
  std::vector<const char*> libraries;  // beginnings of the names of other libraries' headers
};

const std::vector<Floor>& floors() {
  static const std::vector<Floor> all = {
      {"engine", {"engine/"}, {"Eigen/", "metis.h", "tbb/", "oneapi/tbb/"}},
      {"renderer",
       {"renderer/"},
       {"EGL/", "epoxy/", "cairo", "pango/", "fontconfig/", "png.h", "xxhash.h", "opencv2/", "OpenEXR/", "zlib.h"}},
      {"studio",
       {"engine/", "renderer/", "studio/"},
       {"Eigen/", "assimp/", "yaml-cpp/", "CLI/", "spdlog/", "fmt/", "nlohmann/", "hdf5.h", "xxhash.h", "metis.h",
        "oneapi/tbb/"}},
  };
  return all;
}

/// Headers that take seconds to compile.
constexpr std::array kHeavy = {"Eigen/Dense", "nlohmann/json.hpp", "yaml-cpp/yaml.h", "CLI/", "assimp/"};

struct Include {
  std::string file;  // from the project's root
  int line = 0;
  std::string name;
  bool of_project = false;  // in quotation marks
  std::string place() const { return file + ":" + std::to_string(line); }
};

const std::filesystem::path kRoot = THINWALL_SOURCE_DIR;

bool starts_with(const std::string& text, const std::string& beginning) {
  return text.rfind(beginning, 0) == 0;
}

template <typename Beginnings>
bool starts_with_any(const std::string& text, const Beginnings& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const char* beginning) { return starts_with(text, beginning); });
}

/// Headers of the language and of the operating system: no folder, or a folder of the system.
bool is_system(const std::string& name) {
  constexpr std::array kPosix = {"sys/",    "unistd.h", "fcntl.h",   "signal.h",
                                 "spawn.h", "poll.h",   "pthread.h", "sched.h"};
  return name.find('.') == std::string::npos || starts_with_any(name, kPosix);
}

/// What a line includes; an empty name when it includes nothing.
Include include_in(const std::string& text) {
  const std::string word = "#include ";
  if (!starts_with(text, word) || text.size() < word.size() + 2) return {};
  const char closing = text[word.size()] == '"' ? '"' : '>';
  const std::size_t begin = word.size() + 1;
  Include include;
  include.name = text.substr(begin, text.find(closing, begin) - begin);
  include.of_project = closing == '"';
  return include;
}

std::vector<Include> includes_in(const std::string& folder) {
  std::vector<Include> includes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot / folder)) {
    const std::string extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".hpp") continue;
    std::ifstream stream(entry.path());
    std::string text;
    for (int line = 1; std::getline(stream, text); ++line) {
      Include include = include_in(text);
      if (include.name.empty()) continue;
      include.file = std::filesystem::relative(entry.path(), kRoot);
      include.line = line;
      includes.push_back(std::move(include));
    }
  }
  return includes;
}

TEST(ArchitectureTest, EachFloorIncludesOnlyWhatItMay) {
  for (const Floor& floor : floors()) {
    const std::vector<Include> includes = includes_in(floor.folder);
    EXPECT_GT(includes.size(), 20U) << floor.folder << ": no sources were found";
    for (const Include& include : includes) {
      if (include.of_project) {
        EXPECT_TRUE(starts_with_any(include.name, floor.project))
            << include.place() << ": " << floor.folder << " may not include " << include.name;
      } else {
        // Eigen's headers have no extension either, so they are looked for first.
        const bool allowed = starts_with(include.name, "Eigen/")
                                 ? starts_with_any(include.name, floor.libraries)
                                 : is_system(include.name) || starts_with_any(include.name, floor.libraries);
        EXPECT_TRUE(allowed) << include.place() << ": " << floor.folder << " may not include <" << include.name << ">";
      }
    }
  }
}

/// The folder of a file.
std::string room_of(const std::string& file) {
  return std::filesystem::path(file).parent_path();
}

TEST(ArchitectureTest, RoomsIncludeEachOtherInOneDirection) {
  std::map<std::string, std::map<std::string, std::string>> used;  // by room: other rooms, with the first place of each
  for (const Floor& floor : floors()) {
    for (const Include& include : includes_in(floor.folder)) {
      const std::string room = room_of(include.file), other = room_of(include.name);
      used.try_emplace(room);
      if (include.of_project && room != other) used[room].try_emplace(other, include.place());
    }
  }
  EXPECT_GT(used.size(), 30U) << "no rooms were found";
  // Rooms go that use none but those which have gone; what is left uses itself in a circle, or what does.
  std::vector<std::string> gone;
  do {
    for (const std::string& room : gone) used.erase(room);
    gone.clear();
    for (const auto& [room, others] : used) {
      if (std::ranges::none_of(others, [&](const auto& other) { return used.contains(other.first); })) {
        gone.push_back(room);
      }
    }
  } while (!gone.empty());
  for (const auto& [room, others] : used) {
    for (const auto& [other, place] : others) {
      if (used.contains(other)) ADD_FAILURE() << place << ": " << room << " includes " << other;
    }
  }
}

TEST(ArchitectureTest, TheEngineKnowsNoFiles) {
  for (const Include& include : includes_in("engine")) {
    EXPECT_TRUE(include.name != "fstream" && include.name != "filesystem" && include.name != "iostream")
        << include.place() << ": the engine may not include <" << include.name << ">";
  }
}

TEST(ArchitectureTest, NothingIncludesTheCommandsButTheProgramItself) {
  for (const char* folder : {"engine", "renderer", "studio"}) {
    for (const Include& include : includes_in(folder)) {
      if (starts_with(include.file, "studio/commands/")) continue;
      EXPECT_FALSE(starts_with(include.name, "studio/commands/")) << include.place() << ": includes " << include.name;
    }
  }
}

TEST(ArchitectureTest, IncludesAreWrittenFromTheRoot) {
  for (const char* folder : {"engine", "renderer", "studio", "tests"}) {
    for (const Include& include : includes_in(folder)) {
      if (!include.of_project) continue;
      EXPECT_TRUE(std::filesystem::exists(kRoot / include.name))
          << include.place() << ": there is no " << include.name << " in the project";
    }
  }
}

TEST(ArchitectureTest, HeadersOfOursStayLight) {
  for (const char* folder : {"engine", "renderer", "studio"}) {
    for (const Include& include : includes_in(folder)) {
      if (!include.file.ends_with(".hpp")) continue;
      EXPECT_FALSE(starts_with_any(include.name, kHeavy))
          << include.place() << ": " << include.name << " belongs into .cpp files";
    }
  }
}

TEST(ArchitectureTest, TestsMirrorTheRooms) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot / "tests")) {
    // Folders of data belong to the test beside them.
    if (!std::filesystem::exists(entry.path() / "CMakeLists.txt")) continue;
    std::filesystem::path room = std::filesystem::relative(entry.path(), kRoot / "tests");
    // Benchmarks have rooms of their own kind, which mirror the house as the tests do.
    if (*room.begin() == "benchmarks") room = std::filesystem::relative(room, "benchmarks");
    EXPECT_TRUE(std::filesystem::is_directory(kRoot / room)) << "tests/" << room.string() << " mirrors nothing";
  }
}

}  // namespace
}  // namespace thinwall
