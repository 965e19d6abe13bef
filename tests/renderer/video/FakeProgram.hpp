#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/renderer/image/TestFolder.hpp"

namespace thinwall {

/// Where programs are looked up, until the end of the block.
class SearchPath {
 public:
  explicit SearchPath(const std::string& path) : old_(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;
  ~SearchPath() { setenv("PATH", old_.c_str(), 1); }
  const std::string& old() const { return old_; }

 private:
  std::string old_;
};

/// A shell script that is found before the real program; the real one is "$REAL" in it.
class FakeProgram {
 public:
  FakeProgram(const TestFolder& folder, const std::string& name, const std::string& script)
      : path_((folder / "bin").string() + ":" + std::getenv("PATH")) {
    std::filesystem::create_directories(folder / "bin");
    const std::filesystem::path file = folder / ("bin/" + name);
    std::ofstream(file) << "#!/bin/sh\nREAL=$(PATH='" << path_.old() << "' command -v " << name << ")\n"
                        << script << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }

 private:
  SearchPath path_;
};

}  // namespace thinwall
