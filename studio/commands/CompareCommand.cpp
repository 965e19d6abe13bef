#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "renderer/image/Folder.hpp"
#include "renderer/image/PngFile.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/commands/PictureName.hpp"
#include "studio/recorder/Messages.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const PictureComparison& picture) {
  Json json = {{"rung", picture.rung},
               {"largest", picture.difference.largest},
               {"mean", picture.difference.mean},
               {"level", picture.difference.threshold},
               {"pixels_above_level", picture.difference.failing}};
  if (picture.failing) json["failing_fraction"] = picture.failing->fraction();
  if (picture.structure) json["ssim"] = picture.structure->mean;
  if (picture.flip) {
    json["flip"] = picture.flip->mean;
    json["flip_99"] = picture.flip->percentile_99;
  }
  Json worst = Json::array();
  for (const PixelDifference& pixel : picture.difference.worst) {
    worst.push_back({{"x", pixel.x}, {"y", pixel.y}, {"first", pixel.first}, {"second", pixel.second}});
  }
  json["worst"] = worst;
  return json;
}

Json to_json(const VideoFigures& video) {
  Json frames = Json::array();
  for (const FrameFigures& frame : video.different) {
    Json json = {{"frame", frame.frame}, {"time_s", frame.time}, {"largest", frame.largest}, {"mean", frame.mean}};
    if (frame.structure) json["ssim"] = *frame.structure;
    if (frame.flip) json["flip"] = *frame.flip;
    json["within"] = frame.within;
    frames.push_back(json);
  }
  Json json = {{"first_frames", video.first_frames},
               {"second_frames", video.second_frames},
               {"equal_frames", video.equal_frames},
               {"different_frames", frames},
               {"other_differences", video.other}};
  if (video.worst) json["worst_frame"] = video.different[*video.worst].frame;
  return json;
}

Json to_json(const FileComparison& file) {
  Json json = {{"first", file.first.generic_string()},
               {"second", file.second.generic_string()},
               {"outcome", outcome_name(file.outcome)},
               {"kind", file.kind},
               {"verdict", file.verdict}};
  if (file.picture) json["figures"] = to_json(*file.picture);
  if (file.high_range) {
    json["figures"] = {{"hdr_flip", file.high_range->mean},
                       {"hdr_flip_99", file.high_range->percentile_99},
                       {"hdr_flip_largest", file.high_range->largest}};
  }
  if (file.layer) {
    json["figures"] = {{"compared", file.layer->compared},
                       {"failing", file.layer->failing},
                       {"only_in_one", file.layer->only_in_one},
                       {"largest", file.layer->largest},
                       {"mean", file.layer->mean},
                       {"smallest_overlap", file.layer->smallest_overlap},
                       {"worst", file.layer->worst}};
  }
  if (file.video) json["figures"] = to_json(*file.video);
  return json;
}

int exit_code(const std::vector<FileComparison>& files) {
  int code = kExitGood;
  for (const FileComparison& file : files) {
    if (file.outcome == FileOutcome::kUnreadable) return kExitBadInput;
    if (file.outcome != FileOutcome::kEqual && file.outcome != FileOutcome::kWithin) code = kExitRegression;
  }
  return code;
}

void print(const FileComparison& file, bool many) {
  const std::string name = many ? file.second.string() + ": " : "";
  if (file.outcome == FileOutcome::kUnreadable) {
    print_message(stderr, "thinwall: {}\n", file.verdict);
    return;
  }
  print_message(stderr, "{}{}{}{}\n", name, outcome_name(file.outcome), file.verdict == "equal" ? "" : ": ",
                file.verdict == "equal" ? "" : file.verdict);
  if (!many && !file.details.empty()) print_message(stderr, "{}", file.details);
}

void write_difference(const FileComparison& file, const std::filesystem::path& to) {
  if (!file.heat) return;
  if (to.has_parent_path()) make_folder(to.parent_path());
  write_png(to, *file.heat);
}

/// A picture of the difference takes no place of what it is the difference of.
void refuse_to_overwrite(const CompareOptions& options) {
  if (!options.difference) return;
  std::vector<std::filesystem::path> read = {options.first, options.second};
  if (options.comparison.mask) read.push_back(*options.comparison.mask);
  for (const std::filesystem::path& path : read) {
    std::error_code absent;
    if (!std::filesystem::equivalent(path, *options.difference, absent)) continue;
    throw UsageError("--diff " + options.difference->string() +
                     ": this is one of what is compared, and would be overwritten; choose another name");
  }
}

/// Of two folders the differences are a folder, which may be there.
void require_difference_name(const std::filesystem::path& difference, bool is_of_folders) {
  if (!is_of_folders) return require_picture_name("--diff", difference);
  std::error_code absent;
  if (!std::filesystem::exists(difference, absent) || std::filesystem::is_directory(difference, absent)) return;
  throw UsageError("--diff " + difference.string() +
                   ": this is a file, and the differences of two folders go into a folder; choose another name");
}

FileComparison compare_folder_with_file(const CompareOptions& options) {
  FileComparison result{.first = options.first, .second = options.second, .kind = "folder and file"};
  for (const std::filesystem::path& path : {options.first, options.second}) {
    std::error_code unreadable;
    if (std::filesystem::exists(path, unreadable)) continue;
    result.outcome = FileOutcome::kUnreadable;
    result.verdict = "cannot read " + path.string() + ": no such file or folder";
    return result;
  }
  result.outcome = FileOutcome::kDiffers;
  result.verdict = "a folder and a file cannot be equal";
  return result;
}

int compare_two_folders(const CompareOptions& options) {
  const std::vector<FileComparison> files = compare_folders(options.first, options.second, options.comparison);
  if (files.empty()) throw UsageError("both folders are empty, so there is nothing to compare");
  Json list = Json::array();
  std::size_t good = 0;
  for (const FileComparison& file : files) {
    const bool is_good = file.outcome == FileOutcome::kEqual || file.outcome == FileOutcome::kWithin;
    good += is_good ? 1 : 0;
    if (file.outcome != FileOutcome::kEqual) print(file, true);
    if (options.difference && !is_good) {
      std::filesystem::path to = *options.difference / file.second.lexically_relative(options.second);
      write_difference(file, to += ".difference.png");
    }
    list.push_back(to_json(file));
  }
  print_message(stderr, "{} of {} files are equal or within the limits\n", good, files.size());
  const int code = exit_code(files);
  if (options.json) {
    const Json json = {{"files", list}, {"good", good}, {"exit_code", code}};
    print_json(json);
  }
  return code;
}

}  // namespace

int compare(const CompareOptions& options) {
  refuse_to_overwrite(options);
  std::error_code unreadable;
  const bool folders[] = {std::filesystem::is_directory(options.first, unreadable),
                          std::filesystem::is_directory(options.second, unreadable)};
  const bool are_alike = folders[0] == folders[1];
  if (options.difference && are_alike) require_difference_name(*options.difference, folders[0]);
  if (folders[0] && folders[1]) return compare_two_folders(options);
  const FileComparison file =
      are_alike ? compare_files(options.first, options.second, options.comparison) : compare_folder_with_file(options);
  print(file, false);
  if (options.difference) write_difference(file, *options.difference);
  const int code = exit_code({file});
  if (options.json) {
    Json json = to_json(file);
    json["exit_code"] = code;
    print_json(json);
  }
  return code;
}

}  // namespace thinwall
