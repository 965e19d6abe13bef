#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/metric/Ladder.hpp"
#include "renderer/metric/LayerDifference.hpp"

namespace thinwall {

enum class FileOutcome {
  kEqual,         // every decoded pixel, and of videos times and captions
  kWithin,        // within the limits that were given
  kDiffers,       // also: another size, another kind
  kOnlyInFirst,   // of two folders
  kOnlyInSecond,  // likewise
  kUnreadable,
};

/// "equal", "within the limits", "differs", "only in the first", "only in the second", "unreadable"
std::string outcome_name(FileOutcome outcome);

/// A layer of ground truth instead of a picture to look at.
struct LayerChoice {
  LayerKind kind = LayerKind::kDepth;
  LayerTolerance tolerance = {};
  double failing = 0;  // the largest fraction of pixels that may fail
};

struct FileComparisonOptions {
  PictureLimits limits = {};
  WantedFigures wanted = {};
  FlipOptions flip = {};
  std::optional<std::filesystem::path> mask = {};  // a picture, dark where nothing counts
  std::optional<LayerChoice> layer = {};
  bool pixels_only = false;                   // videos: times, captions, chapters and colour tags do not count
  bool wants_picture = false;                 // of the difference
  std::function<void()> between_frames = {};  // called before each file and frame; what it throws goes through
};

/// A frame of a video that is not equal.
struct FrameFigures {
  std::size_t frame = 0;
  double time = 0;     // seconds, in the first file
  double largest = 0;  // 8-bit levels
  double mean = 0;     // 8-bit levels
  std::optional<double> structure = {};
  std::optional<double> flip = {};
  bool within = false;
  std::string verdict = {};  // these figures and others that were judged, each with its limit
};

struct VideoFigures {
  std::size_t first_frames = 0;
  std::size_t second_frames = 0;
  std::size_t equal_frames = 0;
  std::vector<FrameFigures> different;    // in order of time
  std::optional<std::size_t> worst = {};  // of `different`, by mean
  std::vector<std::string> other;         // a sentence for each thing beside pixels that differs
};

/// What came of comparing two files.
struct FileComparison {
  std::filesystem::path first = {};
  std::filesystem::path second = {};
  FileOutcome outcome = FileOutcome::kEqual;
  std::string kind = {};     // "picture", "picture of high range", "video", "depth", ...
  std::string verdict = {};  // one line
  std::string details = {};  // many lines: worst pixels and a map as text; when it differs
  std::optional<PictureComparison> picture = {};
  std::optional<FlipResult> high_range = {};
  std::optional<LayerDifference> layer = {};
  std::optional<VideoFigures> video = {};
  std::optional<Image> heat = {};  // where and how much; of a video its worst frame
};

/// Never throws for what is wrong with the files: that is an outcome. PictureFailure when the ffmpeg program is needed
/// and not there, and ImageUnreadable for the mask.
FileComparison compare_files(const std::filesystem::path& first, const std::filesystem::path& second,
                             const FileComparisonOptions& options = {});

/// The files of two folders and those below with the same relative path, in order of path. Hidden ones are left out.
/// Throws ImageUnreadable for a folder, or one below, that cannot be read.
std::vector<FileComparison> compare_folders(const std::filesystem::path& first, const std::filesystem::path& second,
                                            const FileComparisonOptions& options = {});

}  // namespace thinwall
