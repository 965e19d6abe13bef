#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "studio/scenario/Diagnostics.hpp"
#include "studio/scenario/YamlReader.hpp"

namespace thinwall {

inline std::filesystem::path scenario_test_folder() {
  return std::filesystem::path(THINWALL_SOURCE_DIR) / "tests/studio/scenario";
}

inline std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A text read as the file `test.yaml`.
inline TextNode parse_text(const std::string& text, Diagnostics& diagnostics) {
  return read_yaml_text(text, "test.yaml", diagnostics).value_or(TextNode{});
}

/// `line:column: message` of each, without the file.
inline std::vector<std::string> short_texts(const std::vector<Diagnostic>& diagnostics) {
  std::vector<std::string> texts;
  for (const Diagnostic& diagnostic : diagnostics) {
    texts.push_back(std::to_string(diagnostic.location.line) + ":" + std::to_string(diagnostic.location.column) + ": " +
                    diagnostic.message);
  }
  return texts;
}

}  // namespace thinwall
