#include "studio/comparison/VideoComparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/metric/ErrorPicture.hpp"
#include "renderer/video/FrameReader.hpp"
#include "studio/comparison/FrameSequence.hpp"

namespace thinwall {
namespace {

// Containers keep times in ticks of a thousandth of a second.
constexpr double kSameFrameTime = 1.1e-3;

/// Both frames of a number, while both videos last.
class FramePairs {
 public:
  FramePairs(const FileComparison& files, ImageSize size)
      : readers_{{files.first, size, FramePixels::kRgb8}, {files.second, size, FramePixels::kRgb8}} {
    for (Image& image : images_) {
      image.size = size;
      image.pixels.resize(frame_bytes(size, FramePixels::kRgb8));
    }
  }

  /// Reads on in both; hashes are kept of all frames.
  bool next() {
    for (std::size_t i = 0; i < 2; ++i) {
      there_[i] = readers_[i].next(images_[i].pixels);
      if (there_[i]) hashes_[i].push_back(image_hash(images_[i]));
    }
    return there_[0] || there_[1];
  }
  bool both() const { return there_[0] && there_[1]; }
  bool equal() const { return hashes_[0].back() == hashes_[1].back(); }
  const Image& image(std::size_t which) const { return images_[which]; }
  const std::vector<std::string>& hashes(std::size_t which) const { return hashes_[which]; }

 private:
  FrameReader readers_[2];
  Image images_[2];
  bool there_[2] = {true, true};
  std::vector<std::string> hashes_[2];
};

void compare_lengths(VideoFigures& figures, const FramePairs& pairs) {
  const std::string difference = length_difference(pairs.hashes(0), pairs.hashes(1));
  if (!difference.empty()) figures.other.push_back(difference);
}

void compare_times(VideoFigures& figures, const MediaProbe& first, const MediaProbe& second) {
  const std::size_t count = std::min(first.times.size(), second.times.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (std::abs(first.times[i] - second.times[i]) <= kSameFrameTime) continue;
    figures.other.push_back(
        fmt::format("frame {} is shown at {:.4f} s instead of {:.4f} s", i, second.times[i], first.times[i]));
    return;
  }
}

void compare_tracks(VideoFigures& figures, const FileComparison& files, const MediaProbe& first,
                    const MediaProbe& second) {
  if (first.color != second.color) {
    figures.other.push_back(fmt::format("colours are tagged \"{}\" instead of \"{}\"", second.color, first.color));
  }
  if (first.chapters != second.chapters) figures.other.push_back("the chapters differ");
  if (first.has_captions != second.has_captions) {
    figures.other.push_back(second.has_captions ? "captions are there that the first has not" : "captions are missing");
    return;
  }
  if (first.has_captions && read_captions(files.first) != read_captions(files.second)) {
    figures.other.push_back("the captions differ");
  }
}

/// The frame that differs most, kept to be shown.
struct WorstFrame {
  double mean = -1;
  Image first;
  Image second;
  std::vector<float> errors;
};

FrameFigures judge_frame(const FramePairs& pairs, const PictureOptions& pictures, WorstFrame& worst) {
  const PictureComparison comparison = climb_ladder(pairs.image(0), pairs.image(1), pictures);
  FrameFigures figures{.largest = static_cast<double>(comparison.difference.largest),
                       .mean = comparison.difference.mean,
                       .within = comparison.within,
                       .verdict = comparison.verdict};
  if (comparison.structure) figures.structure = comparison.structure->mean;
  if (comparison.flip) figures.flip = comparison.flip->mean;
  if (figures.mean > worst.mean) {
    worst = {.mean = figures.mean, .first = pairs.image(0), .second = pairs.image(1), .errors = {}};
    if (!pictures.mask.empty()) worst.second = with_masked_pixels_of(worst.second, worst.first, pictures.mask);
    if (comparison.flip) worst.errors = comparison.flip->map;
  }
  return figures;
}

std::string verdict_of(const VideoFigures& figures) {
  std::string verdict;
  if (figures.different.empty()) {
    verdict = fmt::format("{} frames are equal", figures.equal_frames);
  } else {
    const FrameFigures& worst = figures.different[*figures.worst];
    verdict = fmt::format("{} of {} frames differ, the first is frame {} at {:.3f} s; worst frame {} at {:.3f} s: {}",
                          figures.different.size(), figures.different.size() + figures.equal_frames,
                          figures.different.front().frame, figures.different.front().time, worst.frame, worst.time,
                          worst.verdict);
    // The frame with the largest mean may be within all limits where another is beyond one of them.
    const auto beyond = std::ranges::find(figures.different, false, &FrameFigures::within);
    if (worst.within && beyond != figures.different.end()) {
      verdict +=
          fmt::format("; beyond a limit: frame {} at {:.3f} s: {}", beyond->frame, beyond->time, beyond->verdict);
    }
  }
  for (const std::string& sentence : figures.other) verdict += "; " + sentence;
  return verdict;
}

void show_worst(FileComparison& result, const WorstFrame& worst, bool wants_picture) {
  if (result.outcome == FileOutcome::kDiffers) result.details = difference_text(worst.first, worst.second);
  if (!wants_picture) return;
  result.heat =
      worst.errors.empty() ? difference_picture(worst.first, worst.second) : error_picture(worst.first, worst.errors);
}

}  // namespace

void judge_videos(FileComparison& result, const MediaProbe& first, const MediaProbe& second,
                  const PictureOptions& pictures, const FileComparisonOptions& options) {
  VideoFigures figures;
  WorstFrame worst;
  FramePairs pairs(result, first.size);
  bool within = true;
  try {
    for (std::size_t frame = 0; pairs.next(); ++frame) {
      if (options.between_frames) options.between_frames();
      if (!pairs.both()) continue;
      if (pairs.equal()) {
        ++figures.equal_frames;
        continue;
      }
      FrameFigures of_frame = judge_frame(pairs, pictures, worst);
      of_frame.frame = frame;
      of_frame.time = frame < first.times.size() ? first.times[frame] : 0;
      within = within && of_frame.within;
      if (!figures.worst || of_frame.mean > figures.different[*figures.worst].mean) {
        figures.worst = figures.different.size();
      }
      figures.different.push_back(of_frame);
    }
  } catch (const ImageUnreadable& error) {
    result.outcome = FileOutcome::kUnreadable;
    result.verdict = error.what();
    return;
  }
  figures.first_frames = pairs.hashes(0).size();
  figures.second_frames = pairs.hashes(1).size();
  compare_lengths(figures, pairs);
  bool same_length = figures.other.empty();
  if (!options.pixels_only) {
    compare_times(figures, first, second);
    compare_tracks(figures, result, first, second);
  }
  within = within && same_length && figures.other.empty();
  if (!figures.different.empty() || !figures.other.empty()) {
    result.outcome = within ? FileOutcome::kWithin : FileOutcome::kDiffers;
  }
  result.verdict = verdict_of(figures);
  if (worst.mean >= 0) show_worst(result, worst, options.wants_picture);
  result.video = std::move(figures);
}

}  // namespace thinwall
