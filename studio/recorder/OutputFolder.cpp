#include "studio/recorder/OutputFolder.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <system_error>

#include "renderer/image/WholeFile.hpp"
#include "renderer/picture/PictureFailure.hpp"

namespace thinwall {
namespace {

constexpr std::array kResultFiles = {"forces.csv",   "body.csv",   "take.h5",           "video.mp4",
                                     "captions.vtt", "poster.png", "contact_sheet.png", "forces.png",
                                     "energies.png", "points.csv", "manifest.json"};

/// Files of a folder of results are known by how their names begin and by their extensions.
struct ResultFolder {
  const char* name;
  const char* beginnings[2];
  const char* extensions[2];

  bool owns(const std::filesystem::path& file) const {
    const std::string stem = file.stem().string();
    const auto begins = [&](const char* beginning) { return stem.starts_with(beginning); };
    const auto ends = [&](const char* extension) { return file.extension() == extension; };
    return std::any_of(std::begin(beginnings), std::end(beginnings), begins) &&
           std::any_of(std::begin(extensions), std::end(extensions), ends);
  }
};
constexpr std::array kResultFolders = {
    ResultFolder{"frames", {"frame_", "frame_"}, {".png", ".png"}},
    ResultFolder{"surfaces", {"body_", "surfaces"}, {".vtp", ".pvd"}},
};

void check(const std::error_code& error, const std::string& doing, const std::filesystem::path& path) {
  if (!error) return;
  throw PictureFailure("cannot " + doing + " " + path.string() + ": " + error.message() + "; " +
                       cure_for_write_error(error.value()));
}

void remove_file(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::remove(file, error);
  check(error, "remove", file);
}

void remove_results(const std::filesystem::path& folder, const ResultFolder& result) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.is_regular_file() || !result.owns(entry.path())) {
      throw PictureFailure(folder.string() + " holds files that no recording writes (" +
                           entry.path().filename().string() + "); move them away or choose another --out");
    }
  }
  std::filesystem::remove_all(folder, error);
  check(error, "remove", folder);
}

}  // namespace

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  check(error, "make the folder", folder);
}

void rename_folder(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  check(error, "make the folder", to);
}

void prepare_output_folder(const std::filesystem::path& folder) {
  make_folder(folder);
  for (const ResultFolder& result : kResultFolders) {
    remove_results(folder / result.name, result);
    remove_results(unfinished_name(folder / result.name), result);
  }
  for (const char* name : kResultFiles) {
    remove_file(folder / name);
    remove_file(unfinished_name(folder / name));
  }
}

}  // namespace thinwall
