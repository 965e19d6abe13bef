#include <filesystem>
#include <fstream>
#include <iostream>

#include "studio/organs/generator/OrganPlan.hpp"

/// Writes all organs into the folder that the only argument names. Exit code 2 for another number of arguments, 4 when
/// a file cannot be written.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: thinwall_generate_organs FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  for (const thinwall::OrganFile& file : thinwall::organ_files()) {
    std::ofstream stream(folder / file.name, std::ios::binary);
    stream << thinwall::organ_text(file) << std::flush;
    if (!stream) {
      std::cerr << (folder / file.name).string() << ": cannot be written\n";
      return 4;
    }
    std::cerr << (folder / file.name).string() << ": " << file.triangles << " triangles\n";
  }
  return 0;
}
