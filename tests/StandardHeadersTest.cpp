#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace thinwall {
namespace {

/// A header of the language, with what of it our sources use.
struct StandardHeader {
  const char* name;
  std::vector<std::string> uses;  // names behind std::
};

/// Those that a precompiled header or another file of a unity build brings along unasked.
const std::vector<StandardHeader>& standard_headers() {
  static const std::vector<StandardHeader> all = {
      {"algorithm", {"ranges::",  "sort(",      "stable_sort(", "max(",         "min(",         "clamp(", "find(",
                     "find_if(",  "any_of(",    "all_of(",      "none_of(",     "copy(",        "fill(",  "count(",
                     "count_if(", "transform(", "reverse(",     "lower_bound(", "upper_bound(", "unique("}},
      {"array", {"array<"}},
      {"cmath",
       {"sqrt(", "pow(", "exp(", "log(", "sin(", "cos(", "hypot(", "floor(", "ceil(", "isfinite(", "lround(",
        "llround(", "lerp("}},
      {"cstring", {"memcpy(", "memset(", "memcmp(", "memchr(", "memmove("}},
      {"fstream", {"ifstream", "ofstream", "fstream"}},
      {"functional", {"function<"}},
      {"limits", {"numeric_limits<"}},
      {"map", {"map<"}},
      {"memory", {"unique_ptr<", "shared_ptr<", "make_unique<", "make_shared<"}},
      {"numeric", {"accumulate(", "iota(", "partial_sum(", "inner_product("}},
      {"optional", {"optional<", "nullopt"}},
      {"sstream", {"istringstream", "ostringstream", "stringstream"}},
      {"string", {"string ", "to_string("}},
      {"utility", {"pair<", "exchange(", "swap("}},
      {"vector", {"vector<"}},
  };
  return all;
}

/// What each source includes, of ours from the root on, and its text.
struct Source {
  std::set<std::string> includes;
  std::string text;
};

std::map<std::string, Source> sources() {
  const std::filesystem::path root = THINWALL_SOURCE_DIR;
  std::map<std::string, Source> all;
  for (const char* folder : {"engine", "renderer", "studio", "tests"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      Source& source = all[std::filesystem::relative(entry.path(), root)];
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        constexpr std::string_view kInclude = "#include ";
        if (line.starts_with(kInclude)) {
          const std::size_t begin = kInclude.size() + 1;
          source.includes.insert(line.substr(begin, line.find_first_of("\">", begin) - begin));
        }
        source.text += line.substr(0, line.find("//")) + '\n';
      }
    }
  }
  return all;
}

/// Adds all that a file includes, and what that includes.
void add_includes(const std::string& file, const std::map<std::string, Source>& all, std::set<std::string>& found) {
  const auto source = all.find(file);
  if (source == all.end()) return;
  for (const std::string& name : source->second.includes) {
    if (found.insert(name).second) add_includes(name, all, found);
  }
}

TEST(StandardHeadersTest, FilesComeToTheHeadersOfWhatTheyName) {
  const std::map<std::string, Source> all = sources();
  EXPECT_GT(all.size(), 500U) << "no sources were found";
  for (const auto& [file, source] : all) {
    std::set<std::string> found;
    add_includes(file, all, found);
    for (const auto& [name, uses] : standard_headers()) {
      if (found.contains(name)) continue;
      for (const std::string& use : uses) {
        EXPECT_EQ(source.text.find("std::" + use), std::string::npos)
            << file << ": std::" << use << " without <" << name << ">";
      }
    }
  }
}

}  // namespace
}  // namespace thinwall
