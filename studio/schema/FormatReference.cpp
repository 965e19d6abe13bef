#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "studio/schema/JsonSchema.hpp"
#include "studio/schema/ReferencePage.hpp"

namespace {

bool write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text << std::flush;
  if (!stream) std::cerr << "cannot write " << file.string() << "\n";
  return static_cast<bool>(stream);
}

}  // namespace

/// Writes the files that are generated from the table of the scenario format.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: thinwall_format_reference FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder(argv[1]);
  const bool is_written = write(folder / "scenario.schema.json", thinwall::scenario_json_schema()) &&
                          write(folder / "FORMAT.md", thinwall::scenario_reference());
  return is_written ? 0 : 4;
}
