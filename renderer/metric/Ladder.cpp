#include "renderer/metric/Ladder.hpp"

#include "renderer/metric/FigureText.hpp"

namespace thinwall {
namespace {

std::string size_text(ImageSize size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

/// Collects what a comparison says and whether it is still within its limits.
class Verdict {
 public:
  explicit Verdict(PictureComparison& comparison) : comparison_(comparison) {}

  void figure(const std::string& name, double value, std::optional<double> limit,
              GoodFigure good = GoodFigure::kSmall) {
    text_ += (text_.empty() ? "" : ", ") + figure_text(name, value, limit, good);
    if (limit && (good == GoodFigure::kSmall ? value > *limit : value < *limit)) comparison_.within = false;
  }
  void rung(const std::string& name) { comparison_.rung = name; }
  std::string text() const { return text_; }

 private:
  PictureComparison& comparison_;
  std::string text_;
};

void judge_pixels(PictureComparison& result, const Image& first, const Image& second, const PictureOptions& options,
                  Verdict& verdict) {
  const PictureLimits& limits = options.limits;
  result.difference = compare_images(first, second, limits.tolerance.level);
  verdict.rung("pixels");
  verdict.figure("largest difference", result.difference.largest, limits.largest);
  verdict.figure("mean", result.difference.mean, limits.mean);
  result.drift = drift(first, second);
  if (limits.drift) verdict.figure("drift", result.drift.largest(), limits.drift);
  if (!limits.failing) return;
  result.failing = failing_pixels(first, second, limits.tolerance, options.mask);
  verdict.figure("failing fraction", result.failing->fraction(), limits.failing);
}

}  // namespace

PictureComparison climb_ladder(const Image& first, const Image& second_as_given, const PictureOptions& options) {
  PictureComparison result;
  result.difference.first_size = first.size;
  result.difference.second_size = second_as_given.size;
  if (first.size != second_as_given.size) {
    result.difference.verdict = ImageVerdict::kSizeMismatch;
    result.within = false;
    result.rung = "size";
    result.verdict = size_text(second_as_given.size) + " pixels instead of " + size_text(first.size);
    return result;
  }
  const Image masked = options.mask.empty() ? Image{} : with_masked_pixels_of(second_as_given, first, options.mask);
  const Image& second = options.mask.empty() ? second_as_given : masked;
  if (first.pixels == second.pixels) {
    result.rung = "bytes";
    result.verdict = options.mask.empty() ? "equal" : "equal where the mask lets compare";
    if (options.wanted.structure) result.structure = StructuralSimilarity{};
    if (options.wanted.flip) result.flip = FlipResult{};
    return result;
  }
  const PictureLimits& limits = options.limits;
  result.within = limits.any();
  Verdict verdict(result);
  judge_pixels(result, first, second, options, verdict);
  if (options.wanted.structure || (result.within && limits.structure)) {
    if (result.within) verdict.rung("structure");
    result.structure = structural_similarity(first, second, options.flip.threads);
    verdict.figure("SSIM", result.structure->mean, limits.structure, GoodFigure::kLarge);
  }
  if (options.wanted.flip || (result.within && (limits.flip || limits.flip_99))) {
    if (result.within) verdict.rung("flip");
    result.flip = flip(first, second, options.flip);
    verdict.figure("FLIP", result.flip->mean, limits.flip);
    if (limits.flip_99) verdict.figure("FLIP 99th percentile", result.flip->percentile_99, limits.flip_99);
  }
  result.verdict = verdict.text();
  return result;
}

}  // namespace thinwall
