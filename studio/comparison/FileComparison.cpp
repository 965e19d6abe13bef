#include "studio/comparison/FileComparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <future>
#include <limits>
#include <utility>

#include "renderer/image/PngFile.hpp"
#include "renderer/metric/ErrorPicture.hpp"
#include "renderer/metric/FigureText.hpp"
#include "studio/comparison/IdNumbers.hpp"
#include "studio/comparison/IdenticalPictures.hpp"
#include "studio/comparison/PictureFile.hpp"
#include "studio/comparison/VideoComparison.hpp"

namespace thinwall {
namespace {

/// (height x width), zero where nothing counts; empty: all counts.
std::vector<std::uint8_t> mask_for(const FileComparisonOptions& options, ImageSize size) {
  if (!options.mask) return {};
  const Image mask = read_media(*options.mask).image;
  if (mask.size != size) {
    throw ImageUnreadable(fmt::format("the mask {} has {} x {} pixels, the pictures have {} x {}",
                                      options.mask->string(), mask.size.width, mask.size.height, size.width,
                                      size.height));
  }
  return mask_of(mask);
}

PictureOptions picture_options(const FileComparisonOptions& options, ImageSize size) {
  return {.limits = options.limits, .wanted = options.wanted, .mask = mask_for(options, size), .flip = options.flip};
}

/// The numbers of `second`, those of `first` where the mask is zero.
FloatImage with_masked_numbers_of(FloatImage second, const FloatImage& first, const std::vector<std::uint8_t>& mask) {
  if (first.channels != second.channels) return second;
  const auto channels = static_cast<std::size_t>(first.channels);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) std::copy_n(&first.values[channels * i], channels, &second.values[channels * i]);
  }
  return second;
}

/// Finer than 8 bits, and transparency: what the ladder, which sees 8-bit colours over white, does not.
void judge_depth(FileComparison& result, const MediaFile& first, const MediaFile& second,
                 const PictureOptions& options) {
  const PictureLimits& limits = options.limits;
  const DeepDifference difference = compare_deep(first.deep ? *first.deep : deepened(first.image),
                                                 second.deep ? *second.deep : deepened(second.image), options.mask);
  if (difference.largest == 0) return;
  const bool within = limits.any() && (!limits.largest || difference.largest <= *limits.largest) &&
                      (!limits.mean || difference.mean <= *limits.mean);
  if (!within) result.outcome = FileOutcome::kDiffers;
  if (within && result.outcome == FileOutcome::kEqual) result.outcome = FileOutcome::kWithin;
  if (result.verdict == "equal") result.verdict = "equal in 8 bits over white";
  result.verdict += fmt::format("; with 16 bits and transparency: largest difference {:.4g} levels, mean {:.4g}",
                                difference.largest, difference.mean);
}

void judge_pictures(FileComparison& result, const MediaFile& first, const MediaFile& second,
                    const FileComparisonOptions& options) {
  const PictureOptions asked = picture_options(options, first.image.size);
  PictureComparison comparison = climb_ladder(first.image, second.image, asked);
  result.verdict = comparison.verdict;
  const bool same_size = comparison.difference.verdict != ImageVerdict::kSizeMismatch;
  if (comparison.rung != "bytes") result.outcome = comparison.within ? FileOutcome::kWithin : FileOutcome::kDiffers;
  if (same_size && (first.deep || second.deep)) judge_depth(result, first, second, asked);
  const Image counted =
      same_size && !asked.mask.empty() ? with_masked_pixels_of(second.image, first.image, asked.mask) : second.image;
  if (same_size && result.outcome == FileOutcome::kDiffers) {
    result.details = describe(comparison.difference) + "\n" + difference_text(first.image, counted);
  }
  if (same_size && options.wants_picture) {
    const bool by_flip = comparison.flip && !comparison.flip->map.empty();
    result.heat = by_flip ? error_picture(first.image, comparison.flip->map) : difference_picture(first.image, counted);
  }
  result.picture = std::move(comparison);
}

/// Grey numbers as three equal channels, for FLIP.
FloatImage as_colors(const FloatImage& image) {
  if (image.channels == 3) return image;
  FloatImage result{.size = image.size, .channels = 3, .values = {}};
  result.values.reserve(image.values.size() * 3);
  for (const float value : image.values) result.values.insert(result.values.end(), 3, value);
  return result;
}

void judge_high_range(FileComparison& result, const MediaFile& first, const MediaFile& second,
                      const FileComparisonOptions& options) {
  const std::vector<std::uint8_t> mask = mask_for(options, first.size());
  const FloatImage& a = first.numbers;
  const FloatImage b = with_masked_numbers_of(second.numbers, a, mask);
  // By their bits, so that what is not a number equals itself.
  if (a.channels == b.channels && std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0) {
    result.verdict = "equal";
    return;
  }
  const FloatImage colors = as_colors(a);
  result.high_range = flip_high_range(colors, with_masked_numbers_of(as_colors(b), colors, mask), options.flip);
  const PictureLimits& limits = options.limits;
  const bool has_others = limits.largest || limits.mean || limits.drift || limits.failing || limits.structure;
  const bool judged = (limits.flip || limits.flip_99) && !has_others;
  const bool within = judged && (!limits.flip || result.high_range->mean <= *limits.flip) &&
                      (!limits.flip_99 || result.high_range->percentile_99 <= *limits.flip_99);
  result.outcome = within ? FileOutcome::kWithin : FileOutcome::kDiffers;
  result.verdict = figure_text("HDR-FLIP", result.high_range->mean, limits.flip) + ", " +
                   figure_text("99th percentile", result.high_range->percentile_99, limits.flip_99) + ", " +
                   figure_text("largest", result.high_range->largest, {});
  if (has_others) result.verdict += "; of pictures of high range only --flip and --flip-99 can be limits";
  if (options.wants_picture) {
    const auto count = result.high_range->map.size() * 3;
    result.heat =
        error_picture({.size = a.size, .pixels = std::vector<std::uint8_t>(count, 0)}, result.high_range->map);
  }
}

/// The channels that a layer has, of the three of its file.
FloatImage layer_of(const FloatImage& from, LayerKind kind) {
  const int channels = layer_channels(kind);
  if (from.channels == channels) return from;
  FloatImage layer{.size = from.size, .channels = channels, .values = {}};
  for (std::size_t i = 0; i < from.values.size(); i += static_cast<std::size_t>(from.channels)) {
    for (int c = 0; c < channels; ++c)
      layer.values.push_back(from.values[i + static_cast<std::size_t>(c % from.channels)]);
  }
  return layer;
}

/// Whether the third channel of both is 0 or 1 and somewhere 1, as ground truth tells where the flow is known. That of
/// other programs may hold anything.
bool tell_where_known(const FloatImage& first, const FloatImage& second) {
  bool any = false;
  for (const FloatImage* flow : {&first, &second}) {
    if (flow->channels != 3) return false;
    for (std::size_t i = 2; i < flow->values.size(); i += 3) {
      if (flow->values[i] != 0 && flow->values[i] != 1) return false;
      any = any || flow->values[i] == 1;
    }
  }
  return any;
}

FloatImage without_unknown(FloatImage flow) {
  for (std::size_t i = 0; i < flow.values.size(); i += 3) {
    if (flow.values[i + 2] == 0) flow.values[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return flow;
}

std::optional<std::pair<FloatImage, FloatImage>> layers_of(const MediaFile& first, const MediaFile& second,
                                                           LayerKind kind) {
  if (first.kind == MediaKind::kPicture) return id_numbers(first, second);
  if (kind == LayerKind::kFlow && tell_where_known(first.numbers, second.numbers)) {
    return std::pair(layer_of(without_unknown(first.numbers), kind), layer_of(without_unknown(second.numbers), kind));
  }
  return std::pair(layer_of(first.numbers, kind), layer_of(second.numbers, kind));
}

std::string unit_of(LayerKind kind) {
  switch (kind) {
    case LayerKind::kDepth:
      return "m";
    case LayerKind::kNormal:
      return "degrees";
    case LayerKind::kFlow:
      return "px";
    case LayerKind::kIds:
      break;
  }
  return "";
}

/// `fraction`: of the pixels, how many fail.
std::string layer_verdict(const LayerDifference& difference, const LayerChoice& choice, double fraction) {
  const std::string unit = unit_of(choice.kind);
  const std::string figures =
      choice.kind == LayerKind::kIds
          ? fmt::format("smallest overlap {:.4f} of id {}", difference.smallest_overlap, difference.smallest_overlap_id)
          : figure_text("largest difference", difference.largest, choice.tolerance.difference, GoodFigure::kSmall,
                        unit) +
                fmt::format(", mean {:.4g} {}", difference.mean, unit);
  return fmt::format("{}; {} pixels fail, {}, {} of them show something in one only; worst at ({}, {})", figures,
                     difference.failing, figure_text("a fraction of", fraction, choice.failing), difference.only_in_one,
                     difference.worst[0], difference.worst[1]);
}

void judge_layers(FileComparison& result, const MediaFile& first, const MediaFile& second,
                  const std::vector<std::uint8_t>& mask, const LayerChoice& choice) {
  result.kind = layer_name(choice.kind);
  const bool is_ids = choice.kind == LayerKind::kIds;
  if (first.kind == MediaKind::kVideo || (first.kind == MediaKind::kPicture && !is_ids)) {
    result.outcome = FileOutcome::kUnreadable;
    result.verdict = "a layer of " + result.kind + " has to be a file of floating-point numbers: EXR or PFM";
    return;
  }
  const auto layers = layers_of(first, second, choice.kind);
  if (!layers) {
    result.outcome = FileOutcome::kUnreadable;
    result.verdict = "a layer of ids has to be grey of 8 or 16 bits, or colours of 8 bits: " + second.path.string();
    return;
  }
  const FloatImage& layer = layers->first;
  const FloatImage other = with_masked_numbers_of(layers->second, layer, mask);
  const LayerDifference difference = compare_layers(layer, other, choice.kind, choice.tolerance);
  const double pixels = static_cast<double>(first.size().width) * first.size().height;
  const double fraction = static_cast<double>(difference.failing) / pixels;
  const bool equal = difference.failing == 0 && difference.largest == 0;
  if (!equal) result.outcome = fraction <= choice.failing ? FileOutcome::kWithin : FileOutcome::kDiffers;
  result.verdict = equal ? "equal" : layer_verdict(difference, choice, fraction);
  result.layer = difference;
}

void judge(FileComparison& result, const MediaFile& first, const MediaFile& second,
           const FileComparisonOptions& options) {
  result.kind = kind_name(first.kind);
  if (first.kind != second.kind) {
    result.outcome = FileOutcome::kDiffers;
    result.verdict = fmt::format("a {} and a {} cannot be equal", kind_name(first.kind), kind_name(second.kind));
    return;
  }
  if (first.size() != second.size()) {
    result.outcome = FileOutcome::kDiffers;
    result.verdict = fmt::format("{} x {} pixels instead of {} x {}", second.size().width, second.size().height,
                                 first.size().width, first.size().height);
    return;
  }
  if (options.layer) return judge_layers(result, first, second, mask_for(options, first.size()), *options.layer);
  switch (first.kind) {
    case MediaKind::kPicture:
      return judge_pictures(result, first, second, options);
    case MediaKind::kHighRange:
      return judge_high_range(result, first, second, options);
    case MediaKind::kVideo:
      return judge_videos(result, first.probe, second.probe, picture_options(options, first.size()), options);
  }
}

FileComparison of_identical(FileComparison result, ImageSize size, const FileComparisonOptions& options) {
  result.kind = kind_name(MediaKind::kPicture);
  result.verdict = "equal";
  PictureComparison picture;
  picture.rung = "bytes";
  picture.verdict = result.verdict;
  picture.difference.first_size = picture.difference.second_size = size;
  if (options.wanted.structure) picture.structure = StructuralSimilarity{};
  if (options.wanted.flip) picture.flip = FlipResult{};
  result.picture = std::move(picture);
  return result;
}

}  // namespace

std::string outcome_name(FileOutcome outcome) {
  switch (outcome) {
    case FileOutcome::kEqual:
      return "equal";
    case FileOutcome::kWithin:
      return "within the limits";
    case FileOutcome::kDiffers:
      return "differs";
    case FileOutcome::kOnlyInFirst:
      return "only in the first";
    case FileOutcome::kOnlyInSecond:
      return "only in the second";
    case FileOutcome::kUnreadable:
      return "unreadable";
  }
  return "";
}

FileComparison compare_files(const std::filesystem::path& first, const std::filesystem::path& second,
                             const FileComparisonOptions& options) {
  FileComparison result{.first = first, .second = second};
  if (options.between_frames) options.between_frames();
  if (!options.mask && !options.layer && !options.wants_picture) {
    if (const std::optional<ImageSize> size = identical_pictures(first, second))
      return of_identical(result, *size, options);
  }
  std::future<MediaFile> other = std::async(std::launch::async, [&] { return read_media(second); });
  std::optional<MediaFile> one;
  std::optional<MediaFile> two;
  const auto note = [&](const ImageUnreadable& error) {
    result.outcome = FileOutcome::kUnreadable;
    result.verdict += (result.verdict.empty() ? "" : "; ") + std::string(error.what());
  };
  try {
    one = read_media(first);
  } catch (const ImageUnreadable& error) {
    note(error);
  }
  try {
    two = other.get();
  } catch (const ImageUnreadable& error) {
    note(error);
  }
  if (one && two) judge(result, *one, *two, options);
  return result;
}

}  // namespace thinwall
