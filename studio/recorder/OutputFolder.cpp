#include "studio/recorder/OutputFolder.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <system_error>

#include "renderer/image/Folder.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"
#include "studio/recorder/GroundTruthSeries.hpp"

namespace thinwall {
namespace {

constexpr std::array kResultFiles = {"forces.csv",   "body.csv",   "take.h5",           "video.mp4",
                                     "captions.vtt", "poster.png", "contact_sheet.png", "forces.png",
                                     "energies.png", "points.csv", "chambers.csv",      "manifest.json"};

/// What a killed recording may leave of its video besides.
constexpr std::array kPartsOfVideo = {"video.unfinished.recording.mp4", "video.unfinished.captions.vtt",
                                      "video.unfinished.chapters.txt"};

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

/// A killed recording may leave a table that is not whole.
constexpr std::array kGroundTruthTables = {"ground_truth.json",
                                           "annotations.json",
                                           "cameras.csv",
                                           "tools.csv",
                                           "intrinsics.yml",
                                           "ground_truth.unfinished.json",
                                           "annotations.unfinished.json",
                                           "cameras.unfinished.csv",
                                           "tools.unfinished.csv",
                                           "intrinsics.unfinished.yml"};

void check_removal(const std::error_code& error, const std::filesystem::path& path) {
  if (!error) return;
  throw PictureFailure("cannot remove " + path.string() + ": " + error.message() + "; " +
                       cure_for_write_error(error.value()));
}

/// Says whether there was one.
bool remove_file(const std::filesystem::path& file) {
  std::error_code error;
  const bool was_there = std::filesystem::remove(file, error);
  check_removal(error, file);
  return was_there;
}

[[noreturn]] void refuse_foreign(const std::filesystem::path& folder, const std::filesystem::path& file) {
  throw PictureFailure(folder.string() + " holds files that no recording writes (" + file.filename().string() +
                       "); move them away or choose another --out");
}

void require_results_only(const std::filesystem::path& folder, const ResultFolder& result) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.is_regular_file() || !result.owns(entry.path())) refuse_foreign(folder, entry.path());
  }
}

void remove_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::remove_all(folder, error);
  check_removal(error, folder);
}

void remove_results(const std::filesystem::path& folder, const ResultFolder& result) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) return;
  require_results_only(folder, result);
  remove_folder(folder);
}

}  // namespace

void remove_ground_truth(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool is_layer = entry.is_directory() && std::ranges::count(kGroundTruthLayers, name) > 0;
    if (is_layer) require_results_only(entry.path(), {"", {"frame_", "frame_"}, {".exr", ".png"}});
    const bool is_table = entry.is_regular_file() && std::ranges::count(kGroundTruthTables, name) > 0;
    if (!is_layer && !is_table) refuse_foreign(folder, entry.path());
  }
  remove_folder(folder);
}

void remove_second_take(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path name = entry.path().filename();
    const bool is_result = std::ranges::any_of(
        kResultFiles, [&](const char* file) { return name == file || name == unfinished_name(file); });
    if (!is_result) refuse_foreign(folder, name);
  }
  remove_folder(folder);
}

bool prepare_output_folder(const std::filesystem::path& folder) {
  make_folder(folder);
  remove_second_take(folder / kSecondTakeFolder);
  for (const ResultFolder& result : kResultFolders) {
    remove_results(folder / result.name, result);
    remove_results(unfinished_name(folder / result.name), result);
  }
  for (const std::filesystem::path& truth :
       {folder / kGroundTruthFolder, unfinished_name(folder / kGroundTruthFolder)}) {
    remove_ground_truth(truth);
  }
  bool had_results = false;
  for (const char* name : kResultFiles) {
    had_results = remove_file(folder / name) || had_results;
    remove_file(unfinished_name(folder / name));
  }
  for (const char* name : kPartsOfVideo) remove_file(folder / name);
  return had_results;
}

}  // namespace thinwall
