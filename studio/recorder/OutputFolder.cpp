#include "studio/recorder/OutputFolder.hpp"

#include <array>
#include <regex>
#include <system_error>

#include "renderer/image/WholeFile.hpp"
#include "renderer/picture/PictureFailure.hpp"

namespace thinwall {
namespace {

constexpr std::array kResultFiles = {"forces.csv", "body.csv",          "take.h5",    "video.mp4",    "captions.vtt",
                                     "poster.png", "contact_sheet.png", "forces.png", "manifest.json"};

struct ResultFolder {
  const char* name;
  const char* contents;  // a regular expression for the names of the files
};
constexpr std::array kResultFolders = {
    ResultFolder{"frames", R"(frame_\d+(\.unfinished)?\.png)"},
    ResultFolder{"surfaces", R"((body_\d+_\d+|surfaces)(\.unfinished)?\.(vtp|pvd))"},
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

void remove_results(const std::filesystem::path& folder, const std::regex& contents) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.is_regular_file() || !std::regex_match(entry.path().filename().string(), contents)) {
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
    const std::regex contents(result.contents);
    remove_results(folder / result.name, contents);
    remove_results(unfinished_name(folder / result.name), contents);
  }
  for (const char* name : kResultFiles) {
    remove_file(folder / name);
    remove_file(unfinished_name(folder / name));
  }
}

}  // namespace thinwall
